// The light of an imported Babylon.js module, sampled as Babylon's shader does, against means over C on standard input:
// node babylon_check.mjs LAMP.js < "GAMMA,CD" lines. Exits with 1 where one is off by more than 1 % of the peak.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';

// The engine without a screen keeps no texels: they are caught on their way to it.
let texels = null;
const create = NullEngine.prototype.createRawTexture;
NullEngine.prototype.createRawTexture = function (data, ...rest) {
    texels = data;
    return create.call(this, data, ...rest);
};
const scene = new Scene(new NullEngine());
const { makeLights } = await import(pathToFileURL(path.resolve(process.argv[2])));
const [light] = makeLights(scene);
if (!(light.iesProfileTexture instanceof RawTexture)) throw new Error('the light has no profile');

let worst = 0;
let count = 0;
for (const line of fs.readFileSync(0, 'utf8').trim().split('\n')) {
    const [gamma, cd] = line.split(',').map(Number);
    const x = Math.min(Math.max((gamma / 180) * texels.length - 0.5, 0), texels.length - 1);
    const i = Math.floor(x);
    const value = texels[i] + (x - i) * (texels[Math.min(i + 1, texels.length - 1)] - texels[i]);
    worst = Math.max(worst, Math.abs(value * light.intensity - cd) / light.intensity);
    ++count;
}
console.log(`${path.basename(process.argv[2])}: ${count} angles, off by at most ${worst.toExponential(2)} of the peak`);
process.exit(worst < 1e-2 && count > 0 ? 0 : 1);
