// Renders the lights in a program that runs in a page of headless Chromium:
//   node chromium.mjs PROGRAM WORK
// PROGRAM.mjs beside this file exports `version` and `render(light)`, which runs in the page and gives the linear red,
// green and blue of a grey floor, the lowest row first. WORK has the assets, the rigs and node_modules. Writes
// WORK/rendered/PROGRAM.json: the version, and the illuminance of every pixel of each light.
import { createReadStream, existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [program, folder] = process.argv.slice(2);
const work = resolve(folder);
const { default: puppeteer } = await import(
  pathToFileURL(createRequire(join(work, 'package.json')).resolve('puppeteer-core')));

const modules = {
  'three': 'three/build/three.module.js',
  'three/webgpu': 'three/build/three.webgpu.js',
  'three/tsl': 'three/build/three.tsl.js',
  'three/addons/': 'three/examples/jsm/',
  'three/examples/jsm/': 'three/examples/jsm/',
  'three-mesh-bvh': 'three-mesh-bvh/build/index.module.js',
  'three-gpu-pathtracer': 'three-gpu-pathtracer/build/index.module.js',
  'playcanvas': 'playcanvas/build/playcanvas.mjs',
  '@babylonjs/core/': '@babylonjs/core/',
};
const imports = JSON.stringify({ imports: Object.fromEntries(
  Object.entries(modules).map(([name, path]) => [name, `/node_modules/${path}`])) });
const page = `<!DOCTYPE html><title>lights</title><script type="importmap">${imports}</script>
<canvas id="canvas" width="32" height="32"></canvas>
<script src="/node_modules/filament/filament.js"></script>`;
const types = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.json': 'application/json' };

// The page, the programs beside this file, and the work folder, on this machine alone.
const server = createServer((request, answer) => {
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
  if (path === '/') {
    answer.setHeader('Content-Type', 'text/html');
    answer.end(page);
    return;
  }
  const file = path.startsWith('/programs/') ? join(here, path.slice(10)) : join(work, path);
  if (!existsSync(file) || !statSync(file).isFile()) {
    answer.statusCode = 404;
    answer.end();
    return;
  }
  answer.setHeader('Content-Type', types[extname(file)] ?? 'application/octet-stream');
  createReadStream(file).pipe(answer);
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const origin = `http://127.0.0.1:${server.address().port}`;

const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true, protocolTimeout: 600000,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const names = JSON.parse(readFileSync(join(work, 'names.json'), 'utf8'));
const only = process.env.LIGHTS?.split(',');
// The sky is not written for a target that stores none.
const target = { 'threejs-webgl': 'threejs', pathtracer: 'threejs' }[program] ?? program;
const written = new Set(readdirSync(join(work, 'assets', target)).map((file) => file.split('.')[0]));
const output = join(work, 'rendered', `${program}.json`);
mkdirSync(join(work, 'rendered'), { recursive: true });
const rendered = only && existsSync(output) ? JSON.parse(readFileSync(output, 'utf8')) : { program, version: '', lux: {}, failed: {} };
try {
  for (const name of names.filter((one) => written.has(one) && (!only || only.includes(one)))) {
    const tab = await browser.newPage(); // a fresh page for every light: nothing is left of the one before
    if (process.env.VERBOSE) tab.on('console', (line) => console.error(`  ${program}: ${line.text()}`));
    tab.on('pageerror', (error) => { if (process.env.VERBOSE) console.error(`  ${program}: ${error}`); });
    await tab.goto(origin);
    const rendering = tab.evaluate(async (program, name) => {
      try {
        const { render, version } = await import(`/programs/${program}.mjs`);
        return { version, rgb: Array.from(await render(name)) };
      } catch (error) {
        return { error: String(error?.stack ?? error) };
      }
    }, program, name);
    const result = await rendering.catch((error) => ({ error: String(error) })); // it took too long
    await tab.close();
    if (result.error) {
      rendered.failed[name] = result.error;
      continue;
    }
    delete rendered.failed[name];
    rendered.version = result.version;
    // The floor reflects half of its light, the same in every direction.
    const lux = [];
    for (let i = 0; i < result.rgb.length; i += 3)
      lux.push((0.212639 * result.rgb[i] + 0.715169 * result.rgb[i + 1] + 0.072192 * result.rgb[i + 2]) * Math.PI / 0.5);
    rendered.lux[name] = lux;
    writeFileSync(output, JSON.stringify(rendered));
  }
} finally {
  await browser.close();
  server.close();
}
writeFileSync(output, JSON.stringify(rendered));
for (const [name, error] of Object.entries(rendered.failed)) console.error(`${program}: ${name}: ${error}`);
