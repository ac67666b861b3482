// Prints a row for every light that a program rendered, and fails if one differs by more than its bound:
//   node compare.mjs WORK BOUNDS.csv PROGRAM…
// The deviation is that of the worst pixel, as a share of the brightest that probe gives; BOUNDS.csv has those of more
// than 1 %.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const [work, boundsFile, ...programs] = process.argv.slice(2);
const bounds = new Map();
for (const line of readFileSync(boundsFile, 'utf8').split('\n').slice(1)) {
  const [program, light, percent] = line.split(',');
  if (program) bounds.set(`${program},${light}`, Number(percent) / 100);
}
const names = JSON.parse(readFileSync(join(work, 'names.json'), 'utf8'));
const truth = (name) => {
  const rows = readFileSync(join(work, 'probe', `${name}.csv`), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  const column = rows[0].split(',').indexOf('illuminance_lx');
  return rows.slice(1).map((row) => Number(row.split(',')[column]));
};
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

let bad = 0;
console.log(`${'program'.padEnd(26)} ${'light'.padEnd(12)} ${'mean lx'.padStart(9)} ${"probe's".padStart(9)} ${'mean'.padStart(8)} ${'worst'.padStart(8)} ${'bound'.padStart(7)}`);
for (const program of programs) {
  const file = join(work, 'rendered', `${program}.json`);
  if (!existsSync(file)) continue;
  const { version, lux, failed } = JSON.parse(readFileSync(file, 'utf8'));
  for (const name of names) {
    if (failed?.[name]) { console.log(`${`${program} ${version}`.padEnd(26)} ${name.padEnd(12)} failed`); bad++; }
    if (!lux[name]) continue;
    const expected = truth(name);
    if (expected.length !== lux[name].length) throw new Error(`${name}: ${lux[name].length} pixels for ${expected.length}`);
    const brightest = Math.max(...expected);
    const worst = Math.max(...expected.map((value, i) => Math.abs(lux[name][i] - value))) / brightest;
    const ratio = mean(lux[name]) / mean(expected);
    const bound = bounds.get(`${program},${name}`) ?? 0.01;
    const within = worst <= bound;
    if (!within) bad++;
    console.log(`${`${program} ${version}`.padEnd(26)} ${name.padEnd(12)} ${mean(lux[name]).toFixed(3).padStart(9)} ${mean(expected).toFixed(3).padStart(9)} ${(100 * (ratio - 1)).toFixed(3).padStart(7)}% ${(100 * worst).toFixed(3).padStart(7)}% ${(100 * bound).toFixed(1).padStart(6)}%${within ? '' : '  beyond'}`);
  }
}
process.exit(bad === 0 ? 0 : 1);
