// node pack_module.mjs FILE.mjs…: packs the WebAssembly inside modules that Emscripten wrote (unpack_module.mjs) and compresses it. They
// unpack it when they start.
import { readFileSync, writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { Follows, follows, longConstant, streamOf, Streams, takeRare, unpackModule } from './unpack_module.mjs';

const bytesOf = (value) => {
  const bytes = [];
  for (; value >= 128; value = Math.floor(value / 128)) bytes.push(value % 128 | 128);
  return [...bytes, value];
};

function packModule(whole) {
  const streams = Array.from({ length: Streams.count }, () => []);
  let at = 0;
  const bytes = (stream, count) => {
    for (let i = 0; i < count; ++i) streams[stream].push(whole[at++]);
    return whole[at - 1];
  };
  const numberHere = () => {
    let value = 0;
    for (let unit = 1; ; unit *= 128) {
      const byte = whole[at++];
      value += (byte & 127) * unit;
      if (byte < 128) return value;
    }
  };
  const number = (stream) => {
    const from = at;
    const value = numberHere();
    streams[stream].push(...whole.subarray(from, at));
    return value;
  };

  // Tells by how much the depth of blocks changes.
  const takeOperation = (order) => {
    let code = whole[at++];
    if (code === 0x41 && whole[at] >= 128 && whole[at + 1] >= 128) code = longConstant;
    streams[Streams.operation].push(code);
    const stream = streamOf[code];
    switch (follows[code]) {
      case Follows.nothing: break;
      case Follows.variable: {
        const variable = numberHere();
        while (order.length <= variable) order.push(order.length);
        const rank = order.indexOf(variable);
        order.splice(rank, 1);
        order.unshift(variable);
        streams[stream].push(...bytesOf(rank));
        break;
      }
      case Follows.memory:
        number(Streams.alignment + stream);
        if (bytes(Streams.offset + stream, 1) >= 128) number(Streams.furtherOffset);
        break;
      case Follows.number: number(stream); break;
      case Follows.block: number(stream); return 1;
      case Follows.end: return -1;
      default: return takeRare(code, { number, bytes });
    }
    return 0;
  };

  bytes(Streams.rest, 8);
  while (at < whole.length) {
    const section = bytes(Streams.rest, 1);
    const size = number(Streams.rest);
    if (section !== 10) {
      bytes(Streams.rest, size);
      continue;
    }
    for (let count = number(Streams.rest); count > 0; --count) {
      const size = numberHere();
      const end = at + size;
      for (let kinds = number(Streams.locals); kinds > 0; --kinds) {
        number(Streams.locals);
        bytes(Streams.locals, 1);
      }
      const order = [];
      for (let depth = 1; depth > 0;) depth += takeOperation(order);
      if (at !== end) throw new Error('a function that does not end where it should');
    }
  }
  const packed = Buffer.from([...bytesOf(whole.length), ...streams.flatMap(({ length }) => bytesOf(length))]);
  const result = Buffer.concat([packed, ...streams.map((stream) => Buffer.from(stream))]);
  if (Buffer.compare(unpackModule(result), whole) !== 0) throw new Error('what unpacking does not give back');
  return result;
}

const unpacking = readFileSync(new URL('unpack_module.mjs', import.meta.url), 'utf8').replace(/^export |^ *\/\/.*\n/gm, '');
for (const file of process.argv.slice(2)) {
  const text = readFileSync(file, 'utf8');
  const [, encoded] = /"data:application\/octet-stream;base64,([A-Za-z0-9+/=]+)"/.exec(text) ?? [];
  const [ending, create] = /export default (\w+);\s*$/.exec(text) ?? [];
  if (!encoded || !ending) throw new Error(`${file} is no module with WebAssembly in it`);
  const packed = gzipSync(packModule(Buffer.from(encoded, 'base64')), { level: 9 }).toString('base64');
  const embedded = `data:application/octet-stream;base64,${encoded}`;
  writeFileSync(file, `${text.slice(0, -ending.length).replace(embedded, () => 'gonio.wasm')}\n${unpacking}
${create} = withWebAssembly(${create}, "${packed}");
export default ${create};
`);
}
