// WebAssembly in the form in which it compresses best, and back: what is alike stands together, operations in one stream and
// each kind of operand in others. pack_module.mjs packs; a module unpacks itself when it starts.
//
// A packed module has, as LEB128, its size as WebAssembly and the size of each stream, and then the streams.
// The sizes of functions are left out, and variables are written as ranks, the one used last being 0 (J. L. Bentley, D. D. Sleator,
// R. E. Tarjan, V. K. Wei, "A Locally Adaptive Data Compression Scheme", 1986).

// The numbers of the streams.
export const Streams = {
  rest: 0, operation: 1, locals: 2, call: 3, indirect: 4, branch: 5, table: 6, block: 7, short: 8, long: 9, i64: 10, f32: 11, f64: 12,
  vector: 13, constantVector: 14, lane: 15, other: 16, furtherOffset: 17,
  variable: 18, // one each of get, set and tee (0x20 to 0x22), then of global.get and global.set
  alignment: 23, // one each of the operations from 0x28 to 0x3e, then of vectors
  offset: 47, // the first bytes, likewise
  count: 71,
};
export const longConstant = 0xff; // among operations: i32.const (0x41) of a number of three bytes and more, an address

// What follows an operation.
export const Follows = {
  nothing: 0, variable: 1, memory: 2, number: 3, block: 4, end: 5, delegate: 6, two: 7, table: 8, bytes4: 9, bytes8: 10, byte: 11,
  types: 12, vector: 13, more: 14,
};

// For each operation what follows it, and into which stream that goes.
export const follows = new Uint8Array(256);
export const streamOf = new Uint8Array(256);
for (const [from, to, what, stream] of [
  [0x02, 0x04, Follows.block, Streams.block], [0x06, 0x06, Follows.block, Streams.block], // block, loop, if, try
  [0x07, 0x09, Follows.number, Streams.block], [0x0b, 0x0b, Follows.end, 0], [0x18, 0x18, Follows.delegate, Streams.branch], // catch, throw, rethrow
  [0x0c, 0x0d, Follows.number, Streams.branch], [0x0e, 0x0e, Follows.table, Streams.table],
  [0x10, 0x10, Follows.number, Streams.call], [0x12, 0x12, Follows.number, Streams.call], [0xd2, 0xd2, Follows.number, Streams.call],
  [0x11, 0x11, Follows.two, Streams.indirect], [0x13, 0x13, Follows.two, Streams.indirect], [0x1c, 0x1c, Follows.types, Streams.other],
  [0x41, 0x41, Follows.number, Streams.short], [longConstant, longConstant, Follows.number, Streams.long],
  [0x42, 0x42, Follows.number, Streams.i64], [0x43, 0x43, Follows.bytes4, Streams.f32], [0x44, 0x44, Follows.bytes8, Streams.f64],
  [0x3f, 0x40, Follows.byte, Streams.other], [0xd0, 0xd0, Follows.byte, Streams.other],
  [0xfc, 0xfc, Follows.more, Streams.other], [0xfd, 0xfd, Follows.vector, Streams.vector],
]) for (let code = from; code <= to; ++code) {
  follows[code] = what;
  streamOf[code] = stream;
}
for (let code = 0x20; code <= 0x24; ++code) {
  follows[code] = code <= 0x22 ? Follows.variable : Follows.number;
  streamOf[code] = Streams.variable + code - 0x20;
}
for (let code = 0x28; code <= 0x3e; ++code) {
  follows[code] = Follows.memory;
  streamOf[code] = code - 0x28;
}
const vectorMemory = 23; // of vectors, as streamOf of what names memory

// Takes over what follows a rare operation, packing or unpacking: number(stream) and bytes(stream, count), which tells the last one. Tells
// by how much the depth of blocks changes.
export function takeRare(code, { number, bytes }) {
  const stream = streamOf[code];
  switch (follows[code]) {
    case Follows.delegate: number(stream); return -1;
    case Follows.two: number(stream); number(stream); break;
    case Follows.table: for (let left = number(stream); left >= 0; --left) number(stream); break;
    case Follows.bytes4: bytes(stream, 4); break;
    case Follows.bytes8: bytes(stream, 8); break;
    case Follows.byte: bytes(stream, 1); break;
    case Follows.types: bytes(stream, number(stream)); break;
    case Follows.more: { // of memory, tables and conversions
      const more = number(stream);
      for (let left = more < 8 ? 0 : [8, 10, 12, 14].includes(more) ? 2 : 1; left > 0; --left) number(stream);
      break;
    }
    case Follows.vector: {
      const vector = number(stream);
      const withLane = vector >= 84 && vector <= 91;
      if (vector <= 11 || vector === 92 || vector === 93 || withLane) {
        number(Streams.alignment + vectorMemory);
        if (bytes(Streams.offset + vectorMemory, 1) >= 128) number(Streams.furtherOffset);
      }
      if (vector === 12 || vector === 13) bytes(Streams.constantVector, 16);
      else if ((vector >= 21 && vector <= 34) || withLane) bytes(Streams.lane, 1);
    }
  }
  return 0;
}

// What is frequent is in one function, so that it is soon compiled well: a module has a million operations.
export function unpackModule(packed) {
  let at = 0;
  const header = () => {
    let value = 0;
    for (let unit = 1; ; unit *= 128) {
      const byte = packed[at++];
      value += (byte & 127) * unit;
      if (byte < 128) return value;
    }
  };
  const whole = new Uint8Array(header());
  const sizes = Array.from({ length: Streams.count }, header);
  const next = new Int32Array(Streams.count);
  for (let i = 0; i < Streams.count; ++i) {
    next[i] = at;
    at += sizes[i];
  }
  const order = new Uint16Array(65536); // of a function's variables, the one used last being the first
  let end = 0; // of what is unpacked

  const bytes = (stream, count) => {
    for (let i = 0; i < count; ++i) whole[end++] = packed[next[stream]++];
    return whole[end - 1];
  };
  const number = (stream) => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = packed[next[stream]++];
      whole[end++] = byte;
      value |= (byte & 127) << shift;
      if (byte < 128) return value;
    }
  };
  const io = { number, bytes };
  const put = (value) => {
    for (; value >= 128; value >>>= 7) whole[end++] = value & 127 | 128;
    whole[end++] = value;
  };

  const takeFunction = (from) => {
    let to = from;
    let known = 0; // variables in `order`
    let operation = next[Streams.operation];
    let depth = 1;
    while (depth > 0) {
      const code = packed[operation++];
      whole[to++] = code === longConstant ? 0x41 : code;
      const stream = streamOf[code];
      let byte = 0;
      switch (follows[code]) {
        case Follows.nothing: break;
        case Follows.variable: {
          byte = packed[next[stream]++];
          let rank = byte & 127;
          for (let shift = 7; byte >= 128; shift += 7) {
            byte = packed[next[stream]++];
            rank |= (byte & 127) << shift;
          }
          for (; known <= rank; ++known) order[known] = known;
          const variable = order[rank];
          for (let i = rank; i > 0; --i) order[i] = order[i - 1];
          order[0] = variable;
          let left = variable;
          for (; left >= 128; left >>>= 7) whole[to++] = left & 127 | 128;
          whole[to++] = left;
          break;
        }
        case Follows.memory:
          do whole[to++] = byte = packed[next[Streams.alignment + stream]++]; while (byte >= 128);
          whole[to++] = byte = packed[next[Streams.offset + stream]++];
          while (byte >= 128) whole[to++] = byte = packed[next[Streams.furtherOffset]++];
          break;
        case Follows.block: ++depth; // falls through
        case Follows.number:
          do whole[to++] = byte = packed[next[stream]++]; while (byte >= 128);
          break;
        case Follows.end: --depth; break;
        default:
          end = to;
          depth += takeRare(code, io);
          to = end;
      }
    }
    next[Streams.operation] = operation;
    end = to;
  };

  bytes(Streams.rest, 8);
  while (end < whole.length) {
    const section = bytes(Streams.rest, 1);
    const size = number(Streams.rest);
    if (section !== 10) {
      whole.set(packed.subarray(next[Streams.rest], next[Streams.rest] += size), end);
      end += size;
      continue;
    }
    for (let count = number(Streams.rest); count > 0; --count) {
      const start = end;
      end += 2; // the size, if it has two bytes
      for (let kinds = number(Streams.locals); kinds > 0; --kinds) {
        number(Streams.locals);
        bytes(Streams.locals, 1);
      }
      takeFunction(end);
      const length = end - start - 2;
      const digits = length < 128 ? 1 : length < 16384 ? 2 : length < 2097152 ? 3 : 4;
      if (digits !== 2) whole.copyWithin(start + digits, start + 2, end);
      end = start;
      put(length);
      end += length;
    }
  }
  return whole;
}

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// The stream of a Blob would take two to four times as long in Chromium.
async function gunzip(bytes) {
  const { readable, writable } = new DecompressionStream('gzip');
  const writer = writable.getWriter();
  Promise.all([writer.write(bytes), writer.close()]).catch(() => {}); // reading fails then
  const parts = [];
  let size = 0;
  for (const reader = readable.getReader();;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    size += value.length;
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

// Compiles a module packed, by gzip, in base64. To compile it while it is unpacked was no quicker.
export async function compileText(text) {
  return WebAssembly.compile(unpackModule(await gunzip(bytesOfBase64(text))));
}

// What makes an instance, of what Emscripten wrote, create(options). It is compiled once. `module` is one that is compiled already.
export function withWebAssembly(create, text) {
  let compiled;
  return async ({ module, ...options } = {}) => {
    const its = module ?? await (compiled ??= compileText(text));
    return new Promise((resolve, reject) => {
      const instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(its, imports).then((instance) => done(instance, its)).catch(reject);
        return {};
      };
      create({ ...options, instantiateWasm }).then(resolve, reject);
    });
  };
}
