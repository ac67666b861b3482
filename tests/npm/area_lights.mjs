// node area_lights.mjs GONIO: what the area lights of the installed package are made of, against what the tool prints; and
// the lights in Node, without a renderer (tests/shader/three.sh renders them).
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { areaLightData } from './area_light_data.mjs';

const printed = areaLightData((words) => {
  const folder = mkdtempSync(join(tmpdir(), 'gonio-'));
  const stdout = execFileSync(process.argv[2], words, { cwd: folder, encoding: 'utf8' });
  const files = Object.fromEntries(readdirSync(folder).map((name) => [name, readFileSync(join(folder, name))]));
  rmSync(folder, { recursive: true });
  return { stdout, files };
});
const read = (text) => import(`data:text/javascript;base64,${Buffer.from(text).toString('base64')}`);
const inPackage = await read(readFileSync('node_modules/gonio/area-light-data.mjs', 'utf8'));
const expected = await read(printed);
assert.deepEqual(inPackage.glsl, expected.glsl);
assert.equal(inPackage.table_size, expected.table_size);
// Albedos are quadratures: two C libraries may round one to neighbouring halves.
for (const layer of ['leaning', 'reflected']) {
  const [a, b] = [inPackage, expected].map((data) => { const bytes = Buffer.from(data[layer], 'base64'); return new Int16Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)); });
  assert.equal(a.length, b.length);
  a.forEach((half, i) => assert.ok(Math.abs(half - b[i]) <= 1, `${layer}[${i}]`));
}

const { REVISION, ShaderChunk, UniformsLib } = await import('three');
const { DiskAreaLight, GonioAreaLights, SphereAreaLight, TubeAreaLight } = await import('gonio/three-area-lights');
const chunk = ShaderChunk.lights_fragment_begin;
assert.ok(!GonioAreaLights.isReady);
for (const light of [new DiskAreaLight('white', 1000, 0.5), new SphereAreaLight('white', 1000, 0.5), new TubeAreaLight('white', 1000, 0.1, 1)]) {
  assert.ok(light.isLight && light.isRectAreaLight && light.intensity === 1000);
  assert.ok(Math.abs(light.power / (Math.PI * 1000 * light.area) - 1) < 1e-12);
}
assert.ok(GonioAreaLights.isReady && ShaderChunk.lights_fragment_begin !== chunk && UniformsLib.LTC_HALF_1.image.width === inPackage.table_size);
assert.ok(!ShaderChunk.lights_physical_pars_fragment.includes('gonio_tube_shade_ggx_ltc('));
GonioAreaLights.init({ method: 'ltc' });
assert.ok(ShaderChunk.lights_physical_pars_fragment.includes('gonio_tube_shade_ggx_ltc(') && ShaderChunk.lights_physical_pars_fragment.includes('gonio_angle_6[6]'));
assert.throws(() => GonioAreaLights.init({ method: 'lct' }), /unknown method 'lct'; there are: ltc, ltc-share/);
GonioAreaLights.dispose();
assert.ok(ShaderChunk.lights_fragment_begin === chunk && UniformsLib.LTC_HALF_1 === undefined);
console.log(`area lights: ok with three.js r${REVISION}`);
