// PNG as libpng writes it here: no palette, not interlaced.
import { inflateSync } from 'node:zlib';

// {width, height, depth, color, pixels}: bytes as stored.
export function decodePng(bytes) {
  const view = Buffer.from(bytes);
  const parts = [];
  let header;
  for (let at = 8; at < view.length;) {
    const length = view.readUInt32BE(at);
    const type = view.toString('latin1', at + 4, at + 8);
    const body = view.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') header = { width: body.readUInt32BE(0), height: body.readUInt32BE(4), depth: body[8], color: body[9] };
    if (type === 'IDAT') parts.push(body);
    at += 12 + length;
  }
  const { width, height, depth, color } = header;
  const step = { 0: 1, 2: 3, 4: 2, 6: 4 }[color] * depth / 8;
  const packed = inflateSync(Buffer.concat(parts));
  const pixels = new Uint8Array(width * height * step);
  for (let y = 0; y < height; ++y) {
    const filter = packed[y * (width * step + 1)];
    for (let x = 0; x < width * step; ++x) {
      const a = x < step ? 0 : pixels[y * width * step + x - step];
      const b = y === 0 ? 0 : pixels[(y - 1) * width * step + x];
      const c = x < step || y === 0 ? 0 : pixels[(y - 1) * width * step + x - step];
      const p = a + b - c;
      const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const predicted = [0, a, b, (a + b) >> 1, paeth][filter];
      pixels[y * width * step + x] = packed[y * (width * step + 1) + 1 + x] + predicted;
    }
  }
  return { ...header, pixels };
}
