// node pack_tables.mjs IN.cpp OUT.cpp: the same source with its tables of numbers as text in columns, which the module turns
// into the same numbers when it starts. Doubles have seven random bytes and compress to those; their digits are half as many.
import { readFileSync, writeFileSync } from 'node:fs';

const [, , from, to] = process.argv;
const numbers = (text) => text.match(/[-+]?\d[\d.]*(?:e[-+]?\d+)?/g) ?? [];
// Whole numbers by their second differences, since these tables are smooth.
const differences = (column) => column.map((value, i) => value - (i ? column[i - 1] : 0));
const columnText = (column, isWhole) => (isWhole ? differences(differences(column.map(Number))) : column).join(' ');

let count = 0;
const packed = readFileSync(from, 'utf8').replace(
  /^(?:const|constexpr) (std::array<(?:std::array<(.*?), (\d+)>|double), (\d+)>) (\w+)\{([\s\S]*?)\}?\};$/gm,
  (whole, type, element, width, height, name, body) => {
    const flat = numbers(body.replace(/\/\/.*/g, ''));
    const columns = Number(width ?? 1);
    if (flat.length !== columns * Number(height) || /"/.test(body)) return whole; // no table of numbers
    ++count;
    const isWhole = /int/.test(element ?? '');
    const text = Array.from({ length: columns }, (_, c) => columnText(flat.filter((_value, i) => i % columns === c), isWhole)).join(' ');
    return `const ${type} ${name} = unpacked<${type}>(\n    "${text.match(/.{1,110}(?: |$)/g).join('"\n    "')}");`;
  });
if (count === 0) throw new Error(`${from}: no tables`);
writeFileSync(to, packed.replace(/^namespace /m, '#include "unpacked_tables.hpp"\n\nnamespace '));
