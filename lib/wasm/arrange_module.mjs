// node arrange_module.mjs FILE.mjs…: arranges the WebAssembly inside modules so that it compresses to less: functions with much in common
// stand side by side, and data is in one piece, with its zeros. What it does and how quick it is stays the same. A module with what
// this file does not know is left as it is.
import { readFileSync, writeFileSync } from 'node:fs';

const shingleLength = 6; // bytes in a row that two functions have in common…
const mostOwners = 40; // … and no more than this many
const longestGap = 4096; // bytes of zeros between pieces of data that become one

const section = { imports: 2, functions: 3, exports: 7, start: 8, elements: 9, code: 10, data: 11, dataCount: 12 };

class Reader {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }
  byte() { return this.bytes[this.at++]; }
  pass(count) { this.at += count; }
  number() {
    let value = 0;
    for (let unit = 1; ; unit *= 128) {
      const byte = this.byte();
      value += (byte & 127) * unit;
      if (byte < 128) return value;
    }
  }
  signed() { // of 32 bits
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.byte();
      value |= (byte & 127) << shift;
      if (byte < 128) return shift < 25 && byte & 64 ? value | -1 << shift + 7 : value;
    }
  }
  skip(count = 1) { // numbers of any size
    for (; count > 0; --count) while (this.byte() >= 128);
  }
}

const number = (value) => {
  const bytes = [];
  for (; value >= 128; value = Math.floor(value / 128)) bytes.push(value % 128 | 128);
  return Uint8Array.of(...bytes, value);
};
const signed = (value) => {
  const bytes = [];
  for (; value < -64 || value > 63; value >>= 7) bytes.push(value & 127 | 128);
  return Uint8Array.of(...bytes, value & 127);
};

// Goes through the instructions of a body and tells where one names a function.
function eachCall(bytes, from, to, tell) {
  const reader = new Reader(bytes, from);
  while (reader.at < to) {
    const code = reader.byte();
    if (code === 0x10 || code === 0x12 || code === 0xd2) { // call, return_call, ref.func
      const start = reader.at;
      tell(reader.number(), start, reader.at);
    } else if (code === 0x0e) reader.skip(reader.number() + 1); // br_table
    else if (code === 0x1c) reader.pass(reader.number()); // select of a type
    else if (code === 0x11 || code === 0x13 || (code >= 0x28 && code <= 0x3e)) reader.skip(2); // call_indirect, memory
    else if (code === 0x43) reader.at += 4;
    else if (code === 0x44) reader.at += 8;
    else if ((code >= 0x02 && code <= 0x04) || (code >= 0x06 && code <= 0x09) || code === 0x0c || code === 0x0d || code === 0x18 ||
             (code >= 0x20 && code <= 0x26) || (code >= 0x3f && code <= 0x42) || code === 0xd0) reader.skip();
    else if (code === 0xfc) {
      const more = reader.number();
      if (more > 17) throw new Error(`instruction fc ${more}`);
      reader.skip(more < 8 ? 0 : [8, 10, 12, 14].includes(more) ? 2 : 1);
    } else if (code === 0xfd) {
      const more = reader.number();
      if (more > 255) throw new Error(`instruction fd ${more}`);
      if (more <= 11 || more === 92 || more === 93) reader.skip(2);
      else if (more === 12 || more === 13) reader.at += 16;
      else if (more >= 21 && more <= 34) ++reader.at;
      else if (more >= 84 && more <= 91) {
        reader.skip(2);
        ++reader.at;
      }
    } else if (!(code <= 0x01 || code === 0x05 || code === 0x0b || code === 0x0f || (code >= 0x19 && code <= 0x1b) ||
                 (code >= 0x45 && code <= 0xc4) || code === 0xd1)) throw new Error(`instruction ${code.toString(16)}`);
  }
  if (reader.at !== to) throw new Error('a function that does not end where it should');
}

// The numbers of bodies in chains, in which each is beside the two that it has most in common with, as far as those are free.
function byLikeness(bodies) {
  const owners = new Map();
  bodies.forEach((body, i) => {
    const seen = new Set();
    for (let at = 0; at + shingleLength <= body.length; ++at) {
      let hash = 2166136261;
      for (let k = 0; k < shingleLength; ++k) hash = Math.imul(hash ^ body[at + k], 16777619);
      seen.add(hash);
    }
    for (const hash of seen) {
      const list = owners.get(hash);
      if (list === undefined) owners.set(hash, [i]);
      else if (list.length <= mostOwners) list.push(i);
    }
  });
  const likeness = new Map();
  for (const list of owners.values()) {
    if (list.length > mostOwners) continue;
    for (let i = 0; i < list.length; ++i)
      for (let j = i + 1; j < list.length; ++j) {
        const pair = list[i] * bodies.length + list[j];
        likeness.set(pair, (likeness.get(pair) ?? 0) + 1 / (list.length - 1));
      }
  }
  const chain = bodies.map((_, i) => i); // by one of its members
  const chainOf = (i) => {
    while (chain[i] !== i) i = chain[i] = chain[chain[i]];
    return i;
  };
  const beside = bodies.map(() => []);
  for (const [pair] of [...likeness].sort((a, b) => b[1] - a[1])) {
    const a = Math.floor(pair / bodies.length);
    const b = pair % bodies.length;
    if (beside[a].length > 1 || beside[b].length > 1 || chainOf(a) === chainOf(b)) continue;
    chain[chainOf(a)] = chainOf(b);
    beside[a].push(b);
    beside[b].push(a);
  }
  const order = [];
  const taken = new Set();
  bodies.forEach((_, end) => {
    if (beside[end].length > 1) return;
    for (let i = end; i !== undefined && !taken.has(i); i = beside[i].find((other) => !taken.has(other))) {
      taken.add(i);
      order.push(i);
    }
  });
  return order;
}

function arranged(bytes) {
  const sections = [];
  for (const reader = new Reader(bytes, 8); reader.at < bytes.length;) {
    const id = reader.byte();
    const size = reader.number();
    sections.push({ id, from: reader.at, to: reader.at + size });
    if (id > section.dataCount + 1 || id === section.dataCount) throw new Error(`section ${id}`);
    if (id === 0 && Buffer.from(bytes.subarray(reader.at + 1, reader.at + 5)).toString() === 'name') throw new Error('names of functions');
    reader.at += size;
  }
  const find = (id) => {
    const { from } = sections.find((each) => each.id === id) ?? {};
    return from === undefined ? undefined : new Reader(bytes, from);
  };

  let imported = 0;
  for (let reader = find(section.imports), left = reader?.number() ?? 0; left > 0; --left) {
    for (let names = 2; names > 0; --names) reader.pass(reader.number());
    const kind = reader.byte();
    if (kind === 0) ++imported;
    if (kind === 1) reader.byte(); // a table: its type, then its limits
    if (kind === 1 || kind === 2) reader.skip(1 + reader.byte() % 2);
    else if (kind === 4) reader.skip(2); // a tag
    else reader.skip(kind === 3 ? 2 : 1);
    if (kind > 4) throw new Error(`import of kind ${kind}`);
  }
  const types = find(section.functions);
  const functions = Array.from({ length: types.number() }, () => ({ type: types.number() }));
  const code = find(section.code);
  if (code.number() !== functions.length) throw new Error('functions without code');
  for (const each of functions) {
    const size = code.number();
    const from = code.at;
    each.body = bytes.subarray(from, from + size);
    for (let groups = code.number(); groups > 0; --groups) code.skip(2);
    each.first = code.at - from; // instruction, behind the local variables
    code.at = from + size;
  }
  const order = byLikeness(functions.map(({ body }) => body));
  const placed = new Map(order.map((was, now) => [was + imported, now + imported]));
  const renumbered = (index) => number(placed.get(index) ?? index);

  const of = (list) => [number(list.length), ...list.flat()];
  const written = {
    [section.functions]: () => of(order.map((i) => number(functions[i].type))),
    [section.code]: () => of(order.map((i) => {
      const { body, first } = functions[i];
      const parts = [];
      let from = 0;
      eachCall(body, first, body.length, (index, start, end) => {
        parts.push(body.subarray(from, start), renumbered(index));
        from = end;
      });
      const whole = Buffer.concat([...parts, body.subarray(from)]);
      return [number(whole.length), whole];
    })),
    [section.exports]: (reader) => of(Array.from({ length: reader.number() }, () => {
      const from = reader.at;
      reader.pass(reader.number());
      const kind = reader.byte();
      const name = bytes.subarray(from, reader.at);
      const index = reader.number();
      return [name, kind === 0 ? renumbered(index) : number(index)];
    })),
    [section.start]: (reader) => [renumbered(reader.number())],
    [section.elements]: (reader) => of(Array.from({ length: reader.number() }, () => {
      const from = reader.at;
      if (reader.byte() !== 0 || reader.byte() !== 0x41) throw new Error('elements that are no functions in a table');
      reader.skip(2); // where, and the end of that
      const where = bytes.subarray(from, reader.at);
      return [where, ...of(Array.from({ length: reader.number() }, () => renumbered(reader.number())))];
    })),
    [section.data]: (reader) => {
      const pieces = [];
      for (let left = reader.number(); left > 0; --left) {
        if (reader.byte() !== 0 || reader.byte() !== 0x41) throw new Error('data that has no place in memory');
        const at = reader.signed();
        reader.skip(); // the end of the place
        const size = reader.number();
        const piece = bytes.subarray(reader.at, reader.at + size);
        reader.at += size;
        const last = pieces.at(-1);
        const gap = last ? at - last.at - last.size : -1;
        if (gap < 0 || gap > longestGap) pieces.push({ at, size, parts: [piece] });
        else {
          last.parts.push(Buffer.alloc(gap), piece);
          last.size += gap + size;
        }
      }
      return of(pieces.map(({ at, size, parts }) => [Uint8Array.of(0, 0x41), signed(at), Uint8Array.of(0x0b), number(size), ...parts]));
    },
  };
  const parts = [bytes.subarray(0, 8)];
  for (const { id, from, to } of sections) {
    const content = written[id] ? Buffer.concat(written[id](new Reader(bytes, from))) : bytes.subarray(from, to);
    parts.push(Uint8Array.of(id), number(content.length), content);
  }
  const result = Buffer.concat(parts);
  if (!WebAssembly.validate(result)) throw new Error('something that makes it invalid');
  return result;
}

for (const file of process.argv.slice(2)) {
  const text = readFileSync(file, 'utf8');
  const embedded = /(data:application\/octet-stream;base64,)([A-Za-z0-9+/=]+)/;
  const [, , encoded] = embedded.exec(text) ?? [];
  if (!encoded) throw new Error(`${file} has no WebAssembly in it`);
  try {
    const result = arranged(Buffer.from(encoded, 'base64'));
    writeFileSync(file, text.replace(embedded, (_, scheme) => scheme + result.toString('base64')));
  } catch (error) {
    console.warn(`${file} is left as it is: it has ${error.message}`);
  }
}
