// Prints a row for every light that a program rendered, and fails if one differs by more than its bound:
//   node compare.mjs WORK MEASURED.csv update|check PROGRAM=TARGET…
// The deviation is that of the worst pixel, as a share of the brightest that probe gives; three-gpu-pathtracer is noisy, and
// has the worst block of 4 by 4. The bound is 1 %, or a tenth more than MEASURED.csv states. `update` writes what was
// measured into that file.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [work, file, what, ...programs] = process.argv.slice(2);
const header = 'program,version,target,light,percent';
const stated = existsSync(file) ? readFileSync(file, 'utf8').split('\n').slice(1).filter(Boolean).map((line) => line.split(',')) : [];
const names = JSON.parse(readFileSync(join(work, 'names.json'), 'utf8'));

function probed(name) {
  const rows = readFileSync(join(work, 'probe', `${name}.csv`), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  const column = rows[0].split(',').indexOf('illuminance_lx');
  return rows.slice(1).map((row) => Number(row.split(',')[column]));
}
// Means of blocks of pixels.
function blocks(values, side) {
  const wide = Math.sqrt(values.length) / side;
  const sums = new Array(wide * wide).fill(0);
  values.forEach((value, i) => {
    const [row, column] = [Math.floor(i / wide / side), i % (wide * side)];
    sums[Math.floor(row / side) * wide + Math.floor(column / side)] += value / side / side;
  });
  return sums;
}
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const row = (...cells) => console.log(cells.map((cell, i) => (i < 2 ? cell.padEnd(i === 0 ? 24 : 12) : cell.padStart(9))).join(' '));

let bad = 0;
row('program', 'light', 'mean lx', "probe's", 'mean', 'worst', 'bound');
for (const [program, target] of programs.map((one) => one.split('='))) {
  const rendered = join(work, 'rendered', `${program}.json`);
  if (!existsSync(rendered)) {
    console.log(`${program}: nothing was rendered`);
    bad++;
    continue;
  }
  const { version, lux, failed } = JSON.parse(readFileSync(rendered, 'utf8'));
  for (const name of names) {
    if (failed?.[name]) {
      row(`${program} ${version}`, name, 'failed');
      bad++;
    }
    if (!lux[name]) continue;
    const side = program === 'pathtracer' ? 4 : 1;
    const [expected, got] = [blocks(probed(name), side), blocks(lux[name], side)];
    if (expected.length !== got.length) throw new Error(`${name}: ${got.length} pixels for ${expected.length}`);
    const worst = 100 * Math.max(...expected.map((value, i) => Math.abs(got[i] - value))) / Math.max(...expected);
    const ratio = 100 * (mean(got) / mean(expected) - 1);
    const at = stated.findIndex((one) => one[0] === program && one[3] === name);
    const bound = Math.max(1, 1.1 * Number(stated[at]?.[4] ?? 0));
    const within = worst <= bound || what === 'update';
    if (!within) bad++;
    row(`${program} ${version}`, name, mean(got).toFixed(3), mean(expected).toFixed(3), `${ratio.toFixed(2)}%`,
      `${worst.toFixed(3)}%`, `${bound.toFixed(1)}%`, within ? '' : 'beyond');
    if (what === 'update') stated.splice(at < 0 ? stated.length : at, at < 0 ? 0 : 1, [program, version, target, name, worst.toPrecision(2)]);
  }
}
if (what === 'update') writeFileSync(file, [header, ...stated.map((one) => one.join(','))].join('\n') + '\n');
process.exit(bad === 0 ? 0 : 1);
