// The module for JavaScript against the tool: every profile of the tree, every number of `info`, but for sums equal to the last digit.
//   node tests/wasm/module.mjs build/wasm/gonio.mjs build/release/cli/gonio
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { withoutFigures } from './facts.mjs';

const [module, tool] = process.argv.slice(2).map((path) => resolve(path));
const { default: createGonio } = await import(pathToFileURL(module));
const gonio = await createGonio();
const folder = join(dirname(fileURLToPath(import.meta.url)), '../../profiles');
const run = (...words) => execFileSync(tool, words, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });

// The same but for the last of two decimals of a pixel, and for the places of labels on lines, of which two can be equally
// good: sines and powers of two C libraries differ by an ulp.
function expectSameDrawing(drawing, expectedDrawing, what) {
  const [drawn, expected] = [drawing, expectedDrawing].map((svg) => svg.replace(/<text [^>]*paint-order[^\n]*\n/g, ''));
  const number = /-?\d+(\.\d+)?/g;
  assert.ok(drawn.replace(number, '#') === expected.replace(number, '#'), `${what}: another drawing`);
  const others = expected.match(number);
  drawn.match(number).forEach((text, i) => assert.ok(Math.abs(text - others[i]) < 0.0101, `${what}: ${text}, ${others[i]}`));
}

// Numbers that are equal to `tolerance` relative to themselves or to `scale`; all else is the same.
function expectSame(value, expected, what, tolerance, scale) {
  if (typeof expected === 'number' && typeof value === 'number')
    return assert.ok(Math.abs(value - expected) <= tolerance * Math.max(Math.abs(expected), scale), `${what}: ${value}, ${expected}`);
  if (expected === null || typeof expected !== 'object') return assert.equal(value, expected, what);
  assert.deepEqual(Object.keys(value), Object.keys(expected), what);
  for (const key of Object.keys(expected)) expectSame(value[key], expected[key], `${what}: ${key}`, tolerance, scale);
}

// Figures that are sums over many sines and cosines, where two C libraries differ by an ulp.
const sums = ['point_distance_m', 'zones_lm', 'ten_degree_zones_lm', 'cie_flux_code_percent', 'spacing_criterion', 'lcs_lm'];

const names = readdirSync(folder).filter((name) => /\.(ies|ldt|xml)$/.test(name));
assert.ok(names.length > 8);
for (const name of names) {
  const bytes = new Uint8Array(readFileSync(join(folder, name)));
  const profile = gonio.read(bytes, name);
  const expected = withoutFigures(JSON.parse(run('info', '--json', name)));
  const info = profile.info();
  assert.deepEqual(Object.keys(info), Object.keys(expected), name);
  for (const [key, value] of Object.entries(info)) {
    // Angles of types A and B go through arctangents, which differ by an ulp between C libraries.
    const exact = expected.photometry === 'C' ? 0 : 3e-16;
    if (sums.includes(key)) expectSame(value, expected[key], `${name}: ${key}`, 1e-12, expected.flux_lm);
    else expectSame(value, expected[key], `${name}: ${key}`, exact, 0);
  }
  assert.deepEqual(profile.diagnostics, expected.diagnostics, name);

  const gammas = [0, 12.5, 33.3, 60, 89.9, 90, 135];
  const samples = profile.sample(30, gammas);
  gammas.forEach((gamma, i) => assert.equal(samples[i], profile.candela(30, gamma)));

  const checked = gonio.check(bytes, name);
  assert.equal(checked.readable, true);
  assert.deepEqual(checked.diagnostics, JSON.parse(run('check', '--json', name)).diagnostics, name);

  for (const kind of ['polar', 'cartesian', 'heat-map', 'isolux', 'cone'])
    expectSameDrawing(profile.diagram(kind, 720, 720), run('plot', name, '--diagram', kind, '-s', '720x720', '-o', '-'),
      `${name}: ${kind}`);
  profile.delete();
}

const broken = readFileSync(join(folder, 'downlight.ies')).subarray(0, 800);
assert.equal(gonio.check(broken, 'cut.ies').readable, false);
assert.throws(() => gonio.read(broken, 'cut.ies'), (error) =>
  error instanceof Error && error.code === 'IES0206' && error.diagnostics.at(-1).line === 18);
assert.throws(() => gonio.read(new Uint8Array(), 'empty.ies'), Error);
console.log(`${names.length} profiles: numbers, diagnostics and diagrams as from the tool`);
