// three.js with its own RectAreaLight, with the area lights of the npm package, and the truth, pixel by pixel:
//   node three.mjs WORK TOOL TRUTH_PROGRAM
// WORK has node_modules with three and puppeteer-core, and gets pictures. Prints errors and times, and fails if the lights of
// the package are not closer than a RectAreaLight in their place, or farther from the truth than `most`, or if something
// else of what users do with them goes wrong (checks() of scenes.mjs).
import { execFileSync } from 'node:child_process';
import { createReadStream, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, join, normalize, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { areaLightData } from '../../../cli/npm/area_light_data.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [folder, tool, truthProgram] = process.argv.slice(2);
const work = resolve(folder);
const { default: puppeteer } = await import(pathToFileURL(createRequire(join(work, 'package.json')).resolve('puppeteer-core')));
const [width, height] = [80, 60];
const roughnesses = [0.1, 0.3, 0.6];
const surfaces = [{ name: 'dielectric', base: 0.5, metallic: 0 }, { name: 'metal', base: 1, metallic: 1 }];
const most = { gonio: { median: 0.01, p95: 0.1 }, rows: { median: 0.001, p95: 0.02 } }; // of the package's lights, over all pictures of a shape

// The data module, printed by the tool.
const gonio = join(work, 'gonio');
mkdirSync(gonio, { recursive: true });
const run = (words) => {
  const place = join(work, 'run');
  rmSync(place, { recursive: true, force: true });
  mkdirSync(place);
  const stdout = execFileSync(tool, words, { cwd: place, encoding: 'utf8' });
  return { stdout, files: Object.fromEntries(readdirSync(place).map((name) => [name, new Uint8Array(readFileSync(join(place, name)))])) };
};
writeFileSync(join(gonio, 'area-light-data.mjs'), areaLightData(run));

const imports = JSON.stringify({ imports: { three: '/node_modules/three/build/three.module.js', 'three/addons/': '/node_modules/three/examples/jsm/', 'gonio/three-area-lights': '/npm/three-area-lights.mjs' } });
const server = createServer((request, answer) => {
  const path = normalize(new URL(request.url, 'http://localhost').pathname);
  if (path === '/') {
    answer.setHeader('Content-Type', 'text/html');
    answer.end(`<!DOCTYPE html><title>area lights</title><link rel="icon" href="data:,"><script type="importmap">${imports}</script>`);
    return;
  }
  const file = path === '/npm/area-light-data.mjs' ? join(gonio, 'area-light-data.mjs') : path.startsWith('/npm/') ? join(here, '../../../cli/npm', path.slice(5)) : path.startsWith('/scenes/') ? join(here, path.slice(8)) : join(work, path);
  if (!existsSync(file) || !statSync(file).isFile()) {
    answer.statusCode = 404;
    answer.end();
    return;
  }
  answer.setHeader('Content-Type', 'text/javascript');
  createReadStream(file).pipe(answer);
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true, protocolTimeout: 600000, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const failures = [];
const tab = await browser.newPage();
tab.on('console', (message) => { if (['error', 'warn', 'warning'].includes(message.type()) && !/Context Lost|GPU stall/.test(message.text())) failures.push(`console: ${message.text()}`); });
tab.on('pageerror', (error) => failures.push(`page: ${error.message}`));
await tab.goto(`http://127.0.0.1:${server.address().port}/`);
const call = (name, ...words) => tab.evaluate(async (of, values) => (await import('/scenes/scenes.mjs'))[of](...values), name, words);
const version = await tab.evaluate(async () => (await import('/scenes/scenes.mjs')).version);
const shapes = await tab.evaluate(async () => (await import('/scenes/scenes.mjs')).shapes);
const start = (kind, shape) => tab.evaluate(async (of, which) => { (await import('/scenes/scenes.mjs')).rendererOf(of, which); }, kind, shape);

// Where there is something, with its truth.
const cases = [];
for (const shape of shapes) {
  await start('gonio', shape);
  for (const roughness of roughnesses) {
    const found = await call('surfaces', shape, roughness, width, height);
    const places = [];
    for (let i = 0; i < width * height; ++i) if (found.position[4 * i + 3] > 0.5) places.push(i);
    const rows = new Float32Array(10 * places.length);
    places.forEach((i, row) => {
      for (let k = 0; k < 3; ++k) [found.position, found.normal, found.view].forEach((of, part) => { rows[10 * row + 3 * part + k] = of[4 * i + k]; });
      rows[10 * row + 9] = found.view[4 * i + 3];
    });
    for (const surface of surfaces) {
      const file = join(work, 'truth.json');
      writeFileSync(file, JSON.stringify({ lights: [found.light], base: surface.base, metallic: surface.metallic }));
      writeFileSync(join(work, 'pixels.bin'), rows);
      execFileSync(truthProgram, [file, join(work, 'pixels.bin'), join(work, 'truth.bin')]);
      const bytes = readFileSync(join(work, 'truth.bin'));
      cases.push({ shape, roughness, surface, places, truth: [...new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4)] });
    }
  }
}

// Relative to the truth plus a hundredth of its mean, so that what is dark counts little.
const times = {};
const pictures = { own: [], gonio: [], rows: [] };
for (const kind of ['gonio', 'rows', 'own']) {
  for (const each of cases) {
    await start(kind, each.shape);
    const out = await call('picture', kind, each.shape, each.roughness, each.surface.metallic, each.surface.base, width, height);
    const mean = each.truth.reduce((sum, x) => sum + x, 0) / each.truth.length;
    each[kind] = each.places.map((i, row) => Math.abs(out[4 * i] - each.truth[row]) / (each.truth[row] + 0.01 * mean)).map((error) => (Number.isNaN(error) ? Infinity : error));
  }
  for (const shape of [...shapes, 'all four']) {
    await start(kind, shape);
    (times[shape] ??= {})[kind] = await call('frameTime', kind, shape, 8, 512, 384);
  }
  for (const shape of shapes) {
    await start(kind, shape);
    pictures[kind].push(await call('shown', kind, shape, 0.3, 640, 480));
  }
}
const url = await call('joined', [pictures.own, pictures.gonio], 240, 180); // the picture of AREA_LIGHTS.md
writeFileSync(join(work, 'area-lights.png'), Buffer.from(url.split(',')[1], 'base64'));
await start('gonio', 'rect');
failures.push(...await call('checks'));
await browser.close();
server.close();

const summary = (errors) => {
  const sorted = [...errors].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { median: at(0.5), p95: at(0.95), max: sorted.at(-1) };
};
const percent = ({ median, p95, max }) => [median, p95, max].map((x) => (100 * x >= 10 ? (100 * x).toFixed(0) : `${Number((100 * x).toPrecision(2))}`)).join(' | ');
console.log(`three.js r${version}, ${width} × ${height} pixels; errors in % of the truth + 0.01 of its mean\n`);
console.log('| light | surface | roughness | three.js: median | 95 % | max | `ltc-share`: median | 95 % | max | `ltc`: median | 95 % | max |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|');
for (const each of cases) console.log(`| ${each.shape} | ${each.surface.name} | ${each.roughness} | ${['own', 'gonio', 'rows'].map((kind) => percent(summary(each[kind]))).join(' | ')} |`);
for (const shape of shapes) {
  const all = (kind) => summary(cases.filter((each) => each.shape === shape).flatMap((each) => each[kind]));
  const [own, ours, rows] = [all('own'), all('gonio'), all('rows')];
  console.log(`| ${shape} | all | all | ${percent(own)} | ${percent(ours)} | ${percent(rows)} |`);
  if (!(ours.median < own.median && ours.p95 < own.p95)) failures.push(`${shape}: not closer than three.js`);
  for (const [kind, errors] of Object.entries({ gonio: ours, rows }))
    if (!(errors.median <= most[kind].median && errors.p95 <= most[kind].p95)) failures.push(`${shape}, ${kind}: median ${percent(errors)}`);
}
console.log('\n| light | first frame: three.js | `ltc-share` | `ltc` | a frame: three.js | `ltc-share` | `ltc` |\n|---|---:|---:|---:|---:|---:|---:|');
for (const shape of Object.keys(times)) console.log(`| ${shape} | ${[0, 1].map((part) => ['own', 'gonio', 'rows'].map((kind) => `${times[shape][kind][part].toFixed(part)} ms`).join(' | ')).join(' | ')} |`);
if (failures.length > 0) {
  console.error(failures.join('\n'));
  process.exit(1);
}
