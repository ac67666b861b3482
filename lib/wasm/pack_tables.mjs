// node pack_tables.mjs IN.cpp OUT.cpp: the same source with its tables of numbers as one string of bytes, which the module turns into the
// same numbers when it starts (unpacked_tables.hpp). Each number is written as what it differs from what those before it
// in its column let expect, and these differences by an arithmetic coder: half of what the best compressor of text makes of their
// digits.
import { readFileSync, writeFileSync } from 'node:fs';

const [, , from, to] = process.argv;
const maxOrder = 5;
const rowOrders = 3;
const asBits = 40; // in place of a count of decimals: the number as it is stored

// A number as whole / 10^decimals, both exact in double precision; no `whole` where there are none.
function decimal(text) {
  const [mantissa, exponent = '0'] = text.split('e');
  const [whole, fraction = ''] = mantissa.split('.');
  let digits = BigInt(whole + fraction);
  let decimals = fraction.length - Number(exponent);
  while (decimals > 0 && digits % 10n === 0n) { digits /= 10n; --decimals; }
  while (decimals < 0) { digits *= 10n; ++decimals; }
  const number = { whole: Number(digits), decimals, value: Number(text) };
  const isExact = decimals <= 22 && Number.isSafeInteger(number.whole) && number.whole / powerOfTen(decimals) === number.value;
  return isExact ? number : { value: number.value };
}
function powerOfTen(n) {
  let power = 1;
  for (; n > 0; --n) power *= 10;
  return power;
}

// What follows is the counterpart of unpacked_tables.cpp.
function binomial(n, k) {
  let value = 1;
  for (let i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
  return value;
}
function expected(values, i, stride, order, rowOrder) {
  const a = Math.min(order, i % stride);
  const b = Math.min(rowOrder, Math.floor(i / stride));
  let sum = 0;
  for (let k = 0; k <= b; ++k)
    for (let j = k === 0 ? 1 : 0; j <= a; ++j)
      sum += ((j + k) % 2 ? 1 : -1) * binomial(a, j) * binomial(b, k) * values[i - j - k * stride];
  return sum;
}
class Writer {
  constructor() {
    this.bytes = [];
    this.low = 0;
    this.high = 0xffffffff;
    this.contexts = new Map();
  }
  chance(context, kind, n) {
    const key = `${context} ${kind} ${n}`;
    if (!this.contexts.has(key)) this.contexts.set(key, { of_one: 32768, seen: 0 });
    return this.contexts.get(key);
  }
  bit(one, chance) {
    const range = this.high - this.low;
    const middle = this.low + Math.floor(range / 65536) * chance.of_one + Math.floor((range % 65536) * chance.of_one / 65536);
    if (one) this.high = middle;
    else this.low = middle + 1;
    while (Math.floor(this.low / 2 ** 24) === Math.floor(this.high / 2 ** 24)) {
      this.bytes.push(Math.floor(this.high / 2 ** 24));
      this.low = (this.low % 2 ** 24) * 256;
      this.high = (this.high % 2 ** 24) * 256 + 255;
    }
    const step = Math.trunc(2 * ((one ? 65535 : 0) - chance.of_one) / (2 * chance.seen + 3));
    chance.of_one = Math.min(Math.max(chance.of_one + step, 32), 65503);
    if (chance.seen < 30) ++chance.seen;
  }
  // A whole number; returns how many bits it has, by which the next is expected to be large.
  number(value, context) {
    const size = Math.abs(value);
    const length = size === 0 ? 0 : Math.floor(Math.log2(size)) + 1;
    for (let n = 0; n < length; ++n) this.bit(true, this.chance(context, 'longer', n));
    this.bit(false, this.chance(context, 'longer', length));
    for (let n = length - 2; n >= 0; --n)
      this.bit(Math.floor(size / 2 ** n) % 2 === 1, n === length - 2 ? this.chance(context, 'second', length) : { of_one: 32768, seen: 0 });
    if (length > 0) this.bit(value < 0, { of_one: 32768, seen: 0 });
    return length;
  }
  column(numbers, stride) {
    const values = numbers.map(({ value }) => value);
    const differences = (order, rowOrder) => numbers.map(({ whole, decimals }, i) => whole === undefined ? 0 :
      whole - Math.floor(expected(values, i, stride, order, rowOrder) * powerOfTen(decimals) + 0.5));
    let best = { bits: Infinity };
    for (let order = 0; order <= maxOrder; ++order)
      for (let rowOrder = 0; rowOrder <= (stride < numbers.length ? rowOrders : 0); ++rowOrder) {
        const steps = differences(order, rowOrder);
        const bits = steps.reduce((sum, step) => sum + Math.log2(1 + Math.abs(step)), 0);
        if (bits < best.bits) best = { bits, order, rowOrder, steps };
      }
    this.number(best.order, 'order');
    this.number(best.rowOrder, 'order');
    let decimals = 0;
    let last = 0;
    let before = 0;
    numbers.forEach((number, i) => {
      if (number.whole === undefined) {
        this.number(asBits - decimals, 'decimals');
        const bits = new BigUint64Array(Float64Array.of(number.value).buffer)[0];
        for (let n = 63n; n >= 0n; --n) this.bit((bits >> n) % 2n === 1n, { of_one: 32768, seen: 0 });
        return;
      }
      this.number(number.decimals - decimals, 'decimals');
      decimals = number.decimals;
      const length = this.number(best.steps[i], Math.min(20, (last + before + 1) >> 1));
      before = last;
      last = length;
    });
  }
  finish() {
    for (let shift = 24; shift >= 0; shift -= 8) this.bytes.push(Math.floor(this.high / 2 ** shift) % 256);
    return this.bytes;
  }
}

const writer = new Writer();
let count = 0;
const packed = readFileSync(from, 'utf8').replace(
  /^(?:const|constexpr) (std::array<(?:std::array<(.*?), (\d+)>|double|(LtcEntry)), .*>) (\w+)\{([\s\S]*?)\}?\};$/gm,
  (whole, type, element, width, entry, name, body) => {
    const numbers = body.replace(/\/\/.*/g, '').match(/[-+]?\d[\d.]*(?:e[-+]?\d+)?/g) ?? [];
    if (/"/.test(body)) return whole; // no table of numbers
    const columns = entry ? 6 : Number(width ?? 1);
    const rows = numbers.length / columns;
    if (!Number.isInteger(rows) || (!entry && !type.endsWith(`, ${rows}>`))) throw new Error(`${from}: ${name} is no whole table`);
    const stride = entry ? Math.sqrt(rows) : rows; // those of lobes are square
    for (let c = 0; c < columns; ++c) writer.column(numbers.filter((_, i) => i % columns === c).map(decimal), stride);
    ++count;
    return `const ${type} ${name} = packed.table<${element ?? (entry ? 'float' : 'double')}, ${columns}, ${type}>(${stride});`;
  });
if (count === 0) throw new Error(`${from}: no tables`);
const bytes = writer.finish().join(', ').match(/.{1,118}(?:,|$)/g).join('\n    ');
writeFileSync(to, packed.replace(/^namespace gonio[\w:]* \{\n/m, (namespace) => `#include "unpacked_tables.hpp"

${namespace}
static const unsigned char packed_bytes[] = {
    ${bytes}};
static gonio::detail::PackedTables packed(packed_bytes);
`));
