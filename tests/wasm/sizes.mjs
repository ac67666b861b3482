// node sizes.mjs FILE…: the table of the modules' sizes in lib/wasm/README.md.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { brotliCompressSync, constants, gunzipSync, gzipSync } from 'node:zlib';
import { unpackModule } from '../../lib/wasm/unpack_module.mjs';

const group = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, ',');
const row = (name, bytes) => {
  const brotli = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } });
  console.log(`| ${name} | ${group(bytes.length)} | ${group(gzipSync(bytes, { level: 9 }).length)} | ${group(brotli.length)} |`);
};

console.log('| | raw | `gzip -9` | `brotli -q 11` |\n|---|---:|---:|---:|');
for (const file of process.argv.slice(2)) {
  const text = readFileSync(file, 'utf8');
  const name = `\`${basename(file)}\``;
  row(`${name}, with the WebAssembly`, Buffer.from(text));
  const [, encoded] = /= withWebAssembly\(\w+, "([A-Za-z0-9+/=]+)/.exec(text) ?? [];
  if (!encoded) continue;
  const packed = gunzipSync(Buffer.from(encoded, 'base64'));
  row('its WebAssembly, packed', packed);
  row('its WebAssembly, unpacked', unpackModule(packed));
  row('its JavaScript', Buffer.from(text.replace(encoded, '')));
}
