// A zip of stored files: what the tool writes is small or compressed already. PKWARE's APPNOTE 6.3, without extensions;
// the date is the format's first, so that the same files give the same bytes.

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let bit = 0; bit < 8; ++bit) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c >>> 0;
});

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = crcTable[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

// `entries` are bytes by path; paths are relative, with '/'.
export function zipOf(entries) {
  const parts = [];
  const directory = [];
  let offset = 0;
  const put = (bytes) => {
    parts.push(bytes);
    offset += bytes.length;
  };
  const record = (signature, ...fields) => {
    const size = 4 + fields.reduce((sum, [width]) => sum + width, 0);
    const view = new DataView(new ArrayBuffer(size));
    view.setUint32(0, signature, true);
    let at = 4;
    for (const [width, value] of fields) {
      if (width === 2) view.setUint16(at, value, true);
      else view.setUint32(at, value, true);
      at += width;
    }
    return new Uint8Array(view.buffer);
  };
  const utf8Names = 0x0800;
  const firstDay = 0x0021; // 1 January 1980
  for (const [path, bytes] of Object.entries(entries)) {
    const name = new TextEncoder().encode(path);
    const common = [[2, 20], [2, utf8Names], [2, 0], [2, 0], [2, firstDay], [4, crc32(bytes)], [4, bytes.length], [4, bytes.length], [2, name.length], [2, 0]];
    directory.push(record(0x02014b50, [2, 20], ...common, [2, 0], [2, 0], [2, 0], [4, 0], [4, offset]), name);
    put(record(0x04034b50, ...common));
    put(name);
    put(bytes);
  }
  const begin = offset;
  directory.forEach(put);
  const count = directory.length / 2;
  put(record(0x06054b50, [2, 0], [2, 0], [2, count], [2, count], [4, offset - begin], [4, begin], [2, 0]));
  return new Blob(parts, { type: 'application/zip' });
}
