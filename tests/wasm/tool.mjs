// node tool.mjs GONIO_MJS GONIO: the tool as a module against the tool itself: exit status, outputs, messages and files of
// commands of every kind, and pictures pixel by pixel.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';
import { zipOf } from '../../cli/page/zip.mjs';
import { decodePng } from './png.mjs';

const [module, tool] = process.argv.slice(2).map((path) => resolve(path));
const { default: createGonio } = await import(pathToFileURL(module));
const gonio = await createGonio();
const folder = join(dirname(fileURLToPath(import.meta.url)), '../../profiles');
const profiles = Object.fromEntries(readdirSync(folder).filter((name) => /\.(ies|ldt|xml)$/.test(name))
  .map((name) => [name, readFileSync(join(folder, name))]));
const rig = JSON.stringify({
  schema: 'gonio.rig/1', stage: 'room', materials: { wall: 'lambert:albedo=0.6' },
  lights: [{ shape: 'ies:downlight.ies', position: [0.3, 0.1, 2.4] },
           { name: 'bulb', shape: 'sphere:r=6cm', intensity: '300lm', color: '2700K', position: [-0.8, 0.4, 1.2] }],
});
const rows = JSON.stringify({
  schema: 'gonio.rig/1', stage: 'room', luminaires: { lamp: { shape: 'ies:downlight.ies' } },
  lights: [{ luminaire: 'lamp', name: 'row', position: [0, 0, 2.3], array: { count: [3, 2], spacing: [0.8, 1] } },
           { name: 'pair', position: [0, 1, 0], rotate: '90deg', lights: [{ shape: 'cylinder:r=3cm,l=30cm', intensity: '300lm', positions: [[0.5, 0, 2], [-0.5, 0, 2]], target: [0, 0, 0] }] }],
});
// Scenes and containers of other programs.
const zipped = async (entries) => new Uint8Array(await zipOf(entries).arrayBuffer());
const product = `<Root><Header><Manufacturer>Works</Manufacturer><FormatVersion major="1" minor="0" pre-release="3"/></Header><GeneralDefinitions>
<Files><File id="f1" contentType="ldc/eulumdat" type="localFileName">down.ldt</File></Files>
<Photometries><Photometry id="p1"><PhotometryFileReference fileId="f1"/></Photometry></Photometries>
<LightSources><FixedLightSource id="led"><RatedInputPower>12</RatedInputPower></FixedLightSource></LightSources>
<Emitters><Emitter id="down"><FixedLightEmitter><PhotometryReference photometryId="p1"/><LightSourceReference fixedLightSourceId="led"/><RatedLuminousFlux>1000</RatedLuminousFlux></FixedLightEmitter></Emitter></Emitters>
</GeneralDefinitions><ProductDefinitions><ProductMetaData><Name><Locale language="en">Lamp</Locale></Name></ProductMetaData>
<Variants><Variant id="one"><Geometry><EmitterReference emitterId="down"/></Geometry></Variant></Variants></ProductDefinitions></Root>
`;
const ofOthers = {
  'lamp.gldf': await zipped({ 'product.xml': Buffer.from(product), 'ldc/down.ldt': profiles['downlight.ldt'] }),
  'spot.gdtf': await zipped({ 'description.xml': Buffer.from('<GDTF><FixtureType><Geometries><Geometry Name="Base"><Beam Name="Lens"/></Geometry></Geometries></FixtureType></GDTF>') }),
  'scene.usda': '#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = "Z"\n)\ndef CylinderLight "tube"\n{\n    float inputs:intensity = 500\n    float inputs:length = 1.2\n    float inputs:radius = 0.02\n}\n',
  'scene.gltf': JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ name: 'key', translation: [0, 2, 0], extensions: { KHR_lights_punctual: { light: 0 } } }],
    extensionsUsed: ['KHR_lights_punctual'], extensions: { KHR_lights_punctual: { lights: [{ name: 'key', type: 'point', intensity: 60 }] } },
  }),
};
const given = { ...profiles, ...ofOthers, 'rig.json': rig, 'rows.json': rows, 'broken.ies': profiles['downlight.ies'].subarray(0, 700), 'out/': '' };

function runTool(words) {
  const here = mkdtempSync(join(tmpdir(), 'gonio-'));
  try {
    for (const [name, bytes] of Object.entries(given))
      if (name.endsWith('/')) mkdirSync(join(here, name));
      else writeFileSync(join(here, name), bytes);
    const result = spawnSync(tool, words, { cwd: here, maxBuffer: 2 ** 28, env: { PATH: process.env.PATH } });
    const files = {};
    const walk = (path) => readdirSync(path).forEach((name) => {
      const full = join(path, name);
      if (statSync(full).isDirectory()) walk(full);
      else if (!Object.hasOwn(given, relative(here, full))) files[relative(here, full)] = readFileSync(full);
    });
    walk(here);
    return { status: result.status, stdout: result.stdout, stderr: result.stderr.toString(), files };
  } finally {
    rmSync(here, { recursive: true });
  }
}

// The same text but for the last digits of numbers, which functions of two C libraries and sums in other instruction sets
// leave different.
function expectSameText(made, truth, what, tolerance) {
  if (made === truth) return;
  // A hash, a size of a compressed picture, or numbers in base64, of what differs so, are others.
  const [text, expected] = [made, truth].map((all) => all.replace(/(["'])[0-9A-Za-z+/=]{40,}\1/g, '$1…$1').replace(/"(size_)?bytes": \d+/g, ''));
  const number = /-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?/gi;
  assert.equal(text.replace(number, '#'), expected.replace(number, '#'), what);
  const others = expected.match(number).map(Number);
  text.match(number).map(Number).forEach((value, i) => assert.ok(
    Math.abs(value - others[i]) <= tolerance * Math.max(Math.abs(others[i]), 1e-9) + 1e-9, `${what}: ${value}, ${others[i]}`));
}

// 8 bits of a picture: rounding and dithering may fall on either side.
function expectSamePicture(bytes, expected, what) {
  const [made, truth] = [decodePng(bytes), decodePng(expected)];
  for (const key of ['width', 'height', 'depth', 'color']) assert.equal(made[key], truth[key], `${what}: ${key}`);
  let others = 0;
  made.pixels.forEach((value, i) => {
    const off = made.depth === 16 ? Math.abs((value - truth.pixels[i]) << 24 >> 24) : Math.abs(value - truth.pixels[i]);
    if (off > 2) ++others;
  });
  assert.ok(others <= 0.001 * made.pixels.length, `${what}: ${others} of ${made.pixels.length} values differ by more than 2`);
}

// The attributes and the bytes of the pixels of an OpenEXR file of scan lines.
function decodeExr(bytes) {
  const view = Buffer.from(bytes);
  const attributes = {};
  let at = 8;
  const text = () => view.toString('latin1', at, (at = view.indexOf(0, at) + 1) - 1);
  while (view[at] !== 0) {
    const [name, type, size] = [text(), text(), view.readInt32LE(at)];
    at += 4;
    attributes[name] = `${type}:${view.toString('latin1', at, at += size)}`;
  }
  return { attributes, data: at + 1, view };
}

// As 32-bit floats or as halves: {bytes, isHalf}.
function pixelsOfExr({ attributes, data, view }, what) {
  assert.equal(attributes.compression, 'compression:\x03', what);
  const window = Buffer.from(attributes.dataWindow.slice('box2i:'.length), 'latin1');
  const [width, height] = [window.readInt32LE(8) + 1, window.readInt32LE(12) + 1];
  const kinds = Buffer.from(attributes.channels.slice('chlist:'.length), 'latin1');
  let lineBytes = 0;
  for (let at = 0; kinds[at] !== 0;) {
    at = kinds.indexOf(0, at) + 1;
    lineBytes += width * (kinds.readInt32LE(at) === 1 ? 2 : 4);
    at += 16;
  }
  const blocks = [];
  for (let block = 0; block < Math.ceil(height / 16); ++block) {
    const at = Number(view.readBigUInt64LE(data + 8 * block));
    const packed = view.subarray(at + 8, at + 8 + view.readInt32LE(at + 4));
    const size = lineBytes * Math.min(16, height - 16 * block);
    if (packed.length === size) {
      blocks.push(packed);
      continue;
    }
    const parts = inflateSync(packed);
    for (let i = 1; i < size; ++i) parts[i] = parts[i - 1] + parts[i] - 128;
    const half = (size + 1) >> 1;
    blocks.push(Buffer.from(parts, 0).map((_, i) => parts[i % 2 === 0 ? i >> 1 : half + (i >> 1)]));
  }
  return { bytes: Buffer.concat(blocks), isHalf: lineBytes % (4 * width) !== 0 || kinds.readInt32LE(kinds.indexOf(0) + 1) === 1 };
}

function halfOf(bits) {
  const [exponent, mantissa] = [(bits >> 10) & 31, bits & 1023];
  const value = exponent === 0 ? mantissa * 2 ** -24 : exponent === 31 ? Infinity : (1 + mantissa / 1024) * 2 ** (exponent - 15);
  return bits & 0x8000 ? -value : value;
}

// Those that both libraries write alike; numbers of the pixels may differ in the last bit.
function expectSameExr(bytes, expected, what) {
  const [made, truth] = [decodeExr(bytes), decodeExr(expected)];
  const { type, ...others } = truth.attributes; // OpenEXR's library names what all such files are
  assert.deepEqual(Object.keys(made.attributes).sort(), Object.keys(others).sort(), what);
  for (const name of ['channels', 'dataWindow', 'Software', 'capDate']) assert.equal(made.attributes[name], others[name], `${what}: ${name}`);
  const [pixels, right] = [made, truth].map((each) => pixelsOfExr(each, what));
  assert.equal(pixels.bytes.length, right.bytes.length, what);
  const read = ({ bytes, isHalf }, i) => (isHalf ? halfOf(bytes.readUInt16LE(i)) : bytes.readFloatLE(i));
  for (let i = 0; i < right.bytes.length; i += right.isHalf ? 2 : 4) {
    const [a, b] = [read(pixels, i), read(right, i)];
    assert.ok(Math.abs(a - b) <= 1e-3 * Math.abs(b) + 1e-4, `${what}: ${a}, ${b}`);
  }
}

const names = new TextDecoder().decode(gonio.run(['list']).stdout).trim().split('\n').map((line) => line.split(' ')[0]);
assert.ok(names.length > 20);
const commands = [
  ...names.filter((name) => name !== 'simd').map((name) => ['list', name]),
  ...Object.keys(profiles).flatMap((name) => [['info', '--all', name], ['info', '--json', name], ['check', '--json', name],
    ['convert', name, '--to', 'ldt', '-o', 'out/x.ldt'], ['convert', name, '--to', 'tm33', '-o', 'out/x.xml', '--json']]),
  ['units', '800lm', '--shape', 'sphere:r=3cm', '--json'], ['units', '300lx@2m', '--explain'], ['units', '800l'],
  // Words of every kind: the module has a reader of options of its own.
  ['units', '-5lm', '--to', 'cd'], ['units', '-.5lm'], ['list', '--json=true', 'skies'], ['list', '--json=1', 'skies'], ['units', '-q5'],
  ['units', '-qh'], ['units', '--', '--json'], ['units', '800lm', '--to=cd', '--to', 'lx', '--json'], ['units', '800lm', '--to'], ['units', '800lm', '--tu', 'cd'],
  ['units', '800lm', '--to', '--json'], ['preview', '--bounces'], ['units', '-'], ['units', '800lm', '-jq'],
  ['cct', '3000K', '--json'], ['cct', 'xy(0.44,0.4)', '--json'], ['cct', '#ffd9a0'],
  ['explain', '--json'], ['explain', 'WEB0301'], ['help'], ['help', 'preview'], ['frobnicate'], ['info', 'none.ies'],
  ['info', 'broken.ies', '--json'], ['check', 'broken.ies'], ['convert', 'broken.ies', '-o', 'x.ldt'],
  ['edit', 'downlight.ies', '--rotate', '30deg', '--lumens', '900lm', '-o', 'x.ies', '--json'],
  ['edit', 'downlight.ies', 'wall-washer.ies', '--sum', '-o', 'x.ies'],
  ['sample', 'downlight.ies', '--c', '0,90', '--gamma', '0:90:10'],
  ['compare', 'downlight.ies', 'wall-washer.ies', '--json'],
  ['probe', '--rig', 'rig.json', '--at', '0,0,0', '--indirect', '--json'],
  ['probe', 'downlight.ies', '--position', '0,0,2', '--grid', '-1,-1,0:2,0,0:0,2,0:5x5', '--csv'],
  ['rig', 'rig.json'], ['sky', 'cie:12,sun=180/40,horizontal=20klx', '--json'],
  ['import', 'downlight.ies', 'street.ldt', '--to', 'all', '-O', 'out', '-q'],
  ['import', 'rig.json', '--to', 'gltf,blender,usd,pbrt,mitsuba,threejs', '-O', 'out', '-q'],
  ['bake', 'downlight.ies', '--layout', 'latlong', '-s', '64x32', '-o', 'x.png', '--normalize', 'peak', '--json'],
  ['bake', 'street.ldt', '--layout', 'latlong', '-s', '65x33', '-o', 'x.exr', '-q'],
  ['bake', 'street.ldt', '--layout', 'octahedral', '-s', '32x32', '--pixel', 'half', '-o', 'x.exr', '-q'],
  ['plot', 'downlight.ies', '--diagram', 'polar', '-o', 'x.svg'],
  ['rig', 'list', 'rows.json'], ['rig', 'expand', 'rows.json'], ['rig', 'check', 'rig.json', 'rows.json', '--json'],
  ['probe', '--rig', 'rows.json', '--at', '0,0,0', '--json'], ['preview', '--rig', 'rows.json', '-s', '96x64', '-o', 'x.png'],
  ['import', 'rows.json', '--to', 'gltf,usd', '-O', 'out', '-q'],
  ['info', 'lamp.gldf'], ['check', 'lamp.gldf', '--json'], ['convert', 'lamp.gldf', '--to', 'ies', '-o', 'x.ies', '-q'],
  ...Object.keys(ofOthers).map((name) => ['lights', name]), ['lights', 'scene.gltf', '--to-rig', '-o', 'x.json', '-q'],
  ['lights', 'scene.gltf', '--audit', '--json'], ['lights', '--script', 'unreal'],
  ['shader', '--light', 'rect,cylinder', '--lang', 'wgsl'], ['shader', '--material', 'gltf', '--lang', 'glsl-es300'],
  ['units', '800lm', '--shape', 'cylinder:r=3cm,l=30cm', '--to', 'nt', '--json'],
  ['room', '6x4x2.8', '--luminaire', 'downlight.ies', '--for', '300lx', '--json'],
  ['road', '7m', '--luminaire', 'street.ldt', '--height', '8m', '--spacing', '30m', '--json'],
  ['sheet', 'downlight.ies', '-o', 'x.svg', '-q'], ['make', '--flux', '800lm', '--beam', '36deg', '-o', 'x.ies'],
  ['preview', 'downlight.ies', '-s', '96x64', '-o', 'x.png'],
  ['preview', '--rig', 'rig.json', '-s', '96x64', '-o', 'x.png', '--view', 'Filmic'],
  ['preview', '--rig', 'rig.json', '-s', '96x64', '-o', 'x.png', '--look', 'falsecolour'],
  ['preview', '--rig', 'rig.json', '-s', '96x64', '-o', 'x.png', '--look', 'isolux', '--indirect', 'off'],
];

// Without the lines about `gonio bench`, which the module does not have.
const text = (bytes) => Buffer.from(bytes).toString('utf8').replace(/^.*(bench|suites|scalings).*\n/gm, '');
let files = 0;
for (const words of commands) {
  const what = words.join(' ');
  const made = gonio.run(words, given);
  const expected = runTool(words);
  assert.equal(made.status, expected.status, `${what}: ${made.stderr}`);
  expectSameText(made.stderr, expected.stderr, `${what}: stderr`, 1e-4);
  expectSameText(text(made.stdout), text(expected.stdout), `${what}: stdout`, 2e-4);
  assert.deepEqual(Object.keys(made.files).sort(), Object.keys(expected.files).sort(), what);
  for (const [name, bytes] of Object.entries(expected.files)) {
    ++files;
    if (name.endsWith('.png')) expectSamePicture(made.files[name], bytes, `${what}: ${name}`);
    else if (name.endsWith('.exr')) expectSameExr(made.files[name], bytes, `${what}: ${name}`);
    else if (/\.(glb|dds|bin)$/.test(name)) assert.equal(made.files[name].length, bytes.length, `${what}: ${name}`);
    else expectSameText(text(made.files[name]), text(bytes), `${what}: ${name}`, 2e-4);
  }
}
console.log(`${commands.length} commands and their ${files} files: as the tool`);
