// The light of an imported three.js module, sampled as three.js' shader does, against intensities on standard input:
// node threejs_check.mjs LAMP.js < "C,GAMMA,CD" lines. Exits with 1 where one is off by more than 0.5 % of the peak.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { DataUtils } from 'three/webgpu';

const { makeLights } = await import(pathToFileURL(path.resolve(process.argv[2])));
const [light] = makeLights();
const { data, width, height } = light.iesMap.image;

// Linear filtering: clamped across, wrapped down.
function texture(u, v) {
    const x = Math.min(Math.max(u * width - 0.5, 0), width - 1);
    const y = v * height - 0.5;
    const at = (i, j) => DataUtils.fromHalfFloat(
        data[(((j % height) + height) % height) * width + Math.min(i, width - 1)]);
    const [i, j] = [Math.floor(x), Math.floor(y)];
    const row = (k) => at(i, k) + (x - i) * (at(i + 1, k) - at(i, k));
    return row(j) + (y - j) * (row(j + 1) - row(j));
}

let worst = 0;
let count = 0;
for (const line of fs.readFileSync(0, 'utf8').trim().split('\n')) {
    const [c, gamma, cd] = line.split(',').map(Number);
    // The azimuth is that of a perspective projection: what lies behind the light is turned by half a circle.
    const twist = ((c + (gamma > 90 ? 360 : 180)) % 360) / 360 + 0.5 / height;
    const tilt = 0.5 / width + (gamma / 180) * (1 - 1 / width);
    worst = Math.max(worst, Math.abs(texture(tilt, twist) * light.intensity - cd) / light.intensity);
    ++count;
}
console.log(`${path.basename(process.argv[2])}: ${count} directions, off by at most ${worst.toExponential(2)} of the peak`);
process.exit(worst < 5e-3 && count > 0 ? 0 : 1);
