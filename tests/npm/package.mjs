// node package.mjs GONIO PROFILES: the installed package against the tool, its memory over 10,000 profiles, and lights of
// three.js and Babylon.js.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { GonioError, createGonio, wordsOf } from 'gonio';
import { withoutFigures } from './facts.mjs';

const [toolPath, folder] = process.argv.slice(2);
const started = performance.now();
const gonio = await createGonio();
console.log(`ready: ${Math.round(performance.now() - started)} ms after the import`);
const tool = (...words) => execFileSync(toolPath, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
const names = readdirSync(folder).filter((name) => /\.(ies|ldt|xml)$/.test(name));
const bytesOf = (name) => new Uint8Array(readFileSync(join(folder, name)));
const [lamp, file] = [bytesOf('wall-washer.ies'), 'wall-washer.ies'];

// Sums differ in their last digits where sines and arctangents of two C libraries do.
function expectNear(value, expected, what) {
  if (typeof expected === 'number') assert.ok(Math.abs(value - expected) <= 1e-10 * Math.abs(expected) + 1e-9, `${what}: ${value}, ${expected}`);
  else if (Array.isArray(expected)) expected.forEach((each, i) => expectNear(value[i], each, `${what}[${i}]`));
  else if (expected && typeof expected === 'object') for (const key of Object.keys(expected)) expectNear(value[key], expected[key], `${what}.${key}`);
  else assert.equal(value, expected, what);
}

// read, info, sample, diagrams
for (const name of names) {
  const profile = gonio.read(bytesOf(name), name);
  expectNear(profile.info(), withoutFigures(JSON.parse(tool('info', '--json', name))), name);
  assert.equal(profile.sample(30, [0, 45])[1], profile.candela(30, 45));
  assert.match(profile.diagram('polar', 400, 400), /^<\?xml|^<svg/);
  profile.delete();
}

// check, explain, list
assert.deepEqual(gonio.check(lamp, file).diagnostics, JSON.parse(tool('check', '--json', file)).diagnostics);
assert.equal(gonio.explain('WEB0301').severity, 'warning');
assert.ok(gonio.list('layouts').some(({ name }) => name === 'latlong'));

// convert and edit: the bytes of the tool
const scratch = mkdtempSync(join(tmpdir(), 'gonio-'));
for (const to of ['ldt', 'tm33', 'ies']) {
  const made = gonio.convert(lamp, file, { to });
  const path = join(scratch, made.name);
  tool('convert', file, '--to', to, '-o', path, '-q');
  assert.equal(Buffer.compare(Buffer.from(made.bytes), readFileSync(path)), 0, to);
}
const turned = gonio.edit({ [file]: lamp }, { rotate: '90deg', lumens: '1200lm', to: 'ldt' });
assert.ok(Math.abs(turned.report.flux_lm - 1200) < 1e-6);
assert.equal(gonio.edit({ 'a.ies': lamp, 'b.ies': lamp }, { sum: true }).report.flux_lm.toFixed(6),
  (2 * JSON.parse(tool('info', '--json', file)).flux_lm).toFixed(6));

// bake
const profile = gonio.read(lamp, file);
const texture = profile.bake({ layout: 'latlong', width: 64, height: 32 });
assert.ok(texture.data instanceof Float32Array && texture.data.length === 64 * 32);
assert.ok(Math.abs(texture.texture_flux_lm / texture.flux_lm - 1) < 1e-6);
assert.throws(() => profile.bake({ layout: 'latlon' }), (error) => error.code === 'USE0103' && /latlong/.test(error.hint));

// units, colours, probes
assert.equal(gonio.units('800lm', 'nt', { shape: 'sphere:r=3cm' }), JSON.parse(tool('units', '800lm', '--shape', 'sphere:r=3cm', '--to', 'nt', '--json')).results[0].value);
assert.equal(gonio.units('800lm', ['cd', 'lm'])[1], 800);
expectNear(gonio.cct('3000K/0.002'), JSON.parse(tool('cct', '3000K/0.002', '--json')), 'cct');
const rig = { schema: 'gonio.rig/1', stage: 'room', lights: [{ shape: `ies:${file}`, position: [0, 0, 2.4] }] };
const lux = gonio.probe(rig, { [file]: lamp }, { at: ['0,0,0', '0.5,0,0'] });
const rigPath = join(folder, 'npm-test-rig.json');
writeFileSync(rigPath, JSON.stringify(rig));
try {
  lux.points.forEach(({ illuminance_lx: value }, i) => expectNear(value,
    JSON.parse(tool('probe', '--rig', rigPath, '--at=0,0,0', '--at=0.5,0,0', '--json')).points[i].illuminance_lx, 'lux'));
} finally {
  rmSync(rigPath);
}

// pictures
const scene = new gonio.Scene(JSON.stringify(rig), { [file]: lamp });
const picture = scene.render({ width: 80, height: 60 });
assert.equal(picture.rgba.length, 4 * 80 * 60);
assert.ok(picture.rgba.some((value) => value > 60 && value < 250));
assert.ok(scene.at(40, 50).illuminance_lx > 0 && scene.at(-1, 0) === null);
const shown = scene.render({ width: 80, height: 60, mode: 'falsecolour', bounces: 0 });
assert.ok(shown.scale.high > shown.scale.low);
assert.throws(() => scene.render({ width: 0, height: 60 }), Error);
// Another display is not rendered again, and half the light is half of each pixel.
const globe = { ...rig, lights: [{ shape: 'sphere:r=10cm', intensity: '800lm', position: [0, 0, 2.4] }] };
scene.set(JSON.stringify(globe));
const size = { width: 80, height: 60 };
const isRendered = (changed, exposure = 8) => {
  scene.set({ ...globe, ...changed });
  return scene.render({ ...size, exposure }).rendered;
};
assert.equal(isRendered({}), true);
const lux_of_all = scene.at(40, 50).illuminance_lx;
assert.equal(isRendered({}, 7), false);
assert.equal(isRendered({ lights: [{ ...globe.lights[0], dimming: 0.5 }] }), false);
assert.ok(Math.abs(scene.at(40, 50).illuminance_lx / lux_of_all - 0.5) < 1e-6);
assert.equal(isRendered({ lights: [{ ...globe.lights[0], position: [0.2, 0, 2.4] }] }), true);
assert.equal(isRendered({ materials: { floor: 'lambert:albedo=0.1' } }), true);
scene.delete();
// An array and a group are the lights that they stand for.
const rows = { schema: 'gonio.rig/1', stage: 'room', luminaires: { A: { shape: `ies:${file}`, dimming: '50%' } }, lights: [
  { luminaire: 'A', position: [0, 0, 2.4], array: { count: [2, 1], spacing: [1, 1] } }, { position: [0, 0.5, 0], lights: [{ luminaire: 'A', position: [0, 0, 2.4] }] }] };
const places = [[-0.5, 0, 2.4], [0.5, 0, 2.4], [0, 0.5, 2.4]];
const singles = { ...rig, lights: places.map((position) => ({ shape: `ies:${file}`, dimming: 0.5, position })) };
const [ofRows, ofSingles] = [rows, singles].map((each) => gonio.preview(each, { [file]: lamp }, { width: 64, height: 48 }));
assert.deepEqual(ofRows.rgba, ofSingles.rgba);

// targets
const made = gonio.importTo(['gltf', 'unity', 'threejs'], { [file]: lamp }, { flux: '800lm' });
assert.ok(made.files['gltf/wall-washer.gltf'] && made.files['unity/README.md']);
const ofRig = gonio.importTo('blender', { [file]: lamp }, { rig });
assert.ok(Object.keys(ofRig.files).some((name) => name.endsWith('.py')));

// failures
assert.throws(() => gonio.convert(lamp.subarray(0, 600), 'cut.ies', { to: 'ldt' }),
  (error) => error instanceof GonioError && error.status === 4 && /^IES/.test(error.code) && error.diagnostics.at(-1).line > 0);
assert.throws(() => gonio.units('800l', 'nt'), GonioError);
assert.equal(gonio.run(['frobnicate']).status, 2);
assert.deepEqual(wordsOf({ perKlm: true, size: '64x64', position: ['0,0,1', '1,0,1'], no: false }),
  ['--per-klm', '--size=64x64', '--position=0,0,1', '--position=1,0,1']);
for (const name of ['../x.ies', '/x.ies', 'a//b'])
  assert.throws(() => gonio.run(['info', name], { [name]: lamp }), /not the name of a file/);

// No leaks: 10,000 profiles read, measured and deleted, 1,000 commands, 200 scenes.
const use = (count) => {
  for (let i = 0; i < count; ++i) {
    const one = gonio.read(lamp, file);
    one.info();
    one.delete();
  }
};
use(100);
gonio.run(['info', file], { [file]: lamp });
const before = gonio.memoryBytes;
use(10000);
for (let i = 0; i < 1000; ++i) gonio.run(['convert', file, '-o', 'x.ldt', '-q'], { [file]: lamp });
for (let i = 0; i < 200; ++i) {
  const one = new gonio.Scene(JSON.stringify({ ...rig, stage: 'floor' }), { [file]: lamp });
  one.render({ width: 16, height: 12, bounces: 0 });
  one.delete();
}
assert.ok(gonio.memoryBytes - before <= 4 * 1024 * 1024, `${before} bytes of memory became ${gonio.memoryBytes}`);
console.log(`memory: ${before / 2 ** 20} MiB, ${gonio.memoryBytes / 2 ** 20} MiB after 10,000 profiles`);

// three.js and Babylon.js
const THREE = await import('three/webgpu');
const three = (await import('gonio/three')).iesSpotLight(THREE, profile, { flux_lm: 1250 });
assert.ok(Math.abs(three.intensity / (profile.info().peak_cd / 2) - 1) < 1e-3, `${three.intensity}`);
assert.equal(three.iesMap.image.width, 181);
const BABYLON = await import('@babylonjs/core');
const engine = new BABYLON.NullEngine();
const babylon = (await import('gonio/babylon')).iesSpotLight(BABYLON, new BABYLON.Scene(engine), profile);
assert.ok(babylon.intensity > 0 && babylon.iesProfileTexture);
engine.dispose();
profile.delete();

// In a worker.
const source = `const { parentPort } = require('node:worker_threads');
import('gonio').then(async ({ createGonio }) => parentPort.postMessage((await createGonio()).units('800lm', 'cd')));`;
const worker = new Worker(source, { eval: true });
const answer = await new Promise((resolve, reject) => worker.once('message', resolve).once('error', reject));
assert.equal(answer, gonio.units('800lm', 'cd'));
await worker.terminate();
rmSync(scratch, { recursive: true });
console.log(`${names.length} profiles and every function: as the tool`);
