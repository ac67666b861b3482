// The sky of a rig's module for three.js or Babylon.js, as their own loaders read it:
// node sky_check.mjs three|babylon RIG.js < JSON of gonio sky info. Exits with 1 where a plane's illuminance is off by more than 1 % or
// the brightest spot by more than four degrees.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [, , program, file] = process.argv;
const truth = JSON.parse(fs.readFileSync(0, 'utf8'));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const luminance = [0.21263900587151027, 0.71516867876775592, 0.072192315360733714];

// Luminance by direction of gonio's world: Z up, +Y north, +X east.
let lookup;
if (program === 'three') {
    globalThis.fetch = async (request) => new Response(fs.readFileSync(fileURLToPath(request.url)));
    globalThis.ProgressEvent ??= class extends Event {};
    const { addSky } = await import(pathToFileURL(path.resolve(file)));
    const scene = {};
    const { image, flipY } = await addSky(scene);
    const channels = image.data.length / image.width / image.height;
    lookup = (d) => { // equirectUV; rows from below
        const [x, y, z] = [d[0], d[2], -d[1]];
        const u = Math.atan2(z, x) / (2 * Math.PI) + 0.5;
        const v = Math.asin(y) / Math.PI + 0.5;
        const i = Math.min(Math.floor(u * image.width), image.width - 1);
        const j = Math.min(Math.floor((flipY ? 1 - v : v) * image.height), image.height - 1);
        const at = (j * image.width + i) * channels;
        return scene.environmentIntensity * dot(image.data.subarray(at, at + 3), luminance);
    };
} else {
    const { GetCubeMapTextureData } = await import('@babylonjs/core/Misc/HighDynamicRange/hdr.js');
    const text = fs.readFileSync(file, 'utf8');
    const picture = path.join(path.dirname(file), text.match(/new URL\('(.*?)'/)[1]);
    const intensity = Number(text.match(/environmentIntensity = (.*?);/)[1]);
    const size = Number(text.match(/size = (\d+)/)[1]);
    const bytes = fs.readFileSync(picture);
    const faces = GetCubeMapTextureData(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), size, true);
    lookup = (d) => { // a cube map of the graphics interfaces, left-handed with Y up
        const [x, y, z] = [d[0], d[2], d[1]];
        const m = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
        const [face, s, t] = m === Math.abs(x) ? (x > 0 ? ['right', -z, -y] : ['left', z, -y])
            : m === Math.abs(y) ? (y > 0 ? ['up', x, z] : ['down', x, -z]) : z > 0 ? ['front', x, -y] : ['back', -x, -y];
        const at = (c) => Math.min(Math.floor((c / m + 1) / 2 * size), size - 1);
        const index = 3 * (at(t) * size + at(s));
        return intensity * dot(faces[face].subarray(index, index + 3), luminance);
    };
}

const lux = { up: 0, north: 0, east: 0, south: 0, west: 0 };
const normals = { up: [0, 0, 1], north: [0, 1, 0], east: [1, 0, 0], south: [0, -1, 0], west: [-1, 0, 0] };
const rows = 512;
let best = { nits: 0 };
for (let j = 0; j < rows; j++)
    for (let i = 0; i < 2 * rows; i++) {
        const step = Math.PI / rows;
        const [theta, azimuth] = [(j + 0.5) * step, (i + 0.5) * step];
        const d = [Math.sin(theta) * Math.sin(azimuth), Math.sin(theta) * Math.cos(azimuth), Math.cos(theta)];
        const solid = (Math.cos(j * step) - Math.cos((j + 1) * step)) * step;
        const nits = lookup(d);
        if (nits > best.nits) best = { nits, d };
        for (const [name, normal] of Object.entries(normals)) lux[name] += Math.max(dot(d, normal), 0) * solid * nits;
    }
const expected = { up: truth.horizontal_lx, ...truth.vertical_lx };
const worst = Math.max(...Object.keys(lux).map((name) => Math.abs(lux[name] / expected[name] - 1)));
const angle = (degrees) => degrees * Math.PI / 180;
const [az, el] = [angle(truth.brightest.azimuth_deg), angle(truth.brightest.elevation_deg)];
const away = Math.acos(dot(best.d, [Math.sin(az) * Math.cos(el), Math.cos(az) * Math.cos(el), Math.sin(el)])) * 180 / Math.PI;
console.log(`${program}: five planes within ${(100 * worst).toFixed(3)} %, brightest spot ${away.toFixed(2)} degrees away`);
process.exit(worst < 0.01 && away < 4 ? 0 : 1);
