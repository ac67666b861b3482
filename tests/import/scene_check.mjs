// The lights of a rig's module for three.js or Babylon.js, evaluated at points by the formulas of their shaders:
// node scene_check.mjs three|babylon RIG.js < JSON, an array of { position, lights: { NAME: lux } } on planes that look
// up. Exits with 1 where a light is off by more than 1 % of its brightest. Profiles are looked up by the other checks:
// here what stands for their place and frame is held against the rig.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [, , program, file] = process.argv;
const { makeLights } = await import(pathToFileURL(path.resolve(file)));
const truth = JSON.parse(fs.readFileSync(0, 'utf8'));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const smoothstep = (x) => { const t = Math.min(Math.max(x, 0), 1); return t * t * (3 - 2 * t); };
const luminance = [0.21263900587151027, 0.71516867876775592, 0.072192315360733714];
const list = [];

// intensity(away), by world direction of the right-handed world with Z up.
function punctual(position, intensity) {
    return (p) => {
        const away = minus(p, position);
        return intensity(away) * Math.max(-away[2], 0) / dot(away, away) ** 1.5;
    };
}

if (program === 'three') {
    const { DataUtils } = await import('three/webgpu');
    const world = (v) => [v.x, -v.z, v.y];
    for (const light of makeLights()) {
        light.updateMatrixWorld();
        light.target?.updateMatrixWorld();
        const level = dot([light.color.r, light.color.g, light.color.b], luminance) * light.intensity;
        const position = world(light.position);
        const aim = light.target ? minus(world(light.target.position), position) : null;
        let lux = null;
        if (light.isRectAreaLight) {
            const axis = (k) => { const e = light.matrixWorld.elements.slice(4 * k, 4 * k + 3); return [e[0], -e[2], e[1]]; };
            const [x, y, z] = [axis(0), axis(1), axis(2)];
            const n = 64;
            lux = (p) => {
                let total = 0;
                for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) {
                    const [u, v] = [((i + 0.5) / n - 0.5) * light.width, ((j + 0.5) / n - 0.5) * light.height];
                    const away = minus(p, position.map((o, k) => o + u * x[k] + v * y[k]));
                    const facing = -dot(away, z);
                    if (facing > 0 && away[2] < 0) total += facing * -away[2] / dot(away, away) ** 2;
                }
                return total * level * light.width * light.height / n / n;
            };
        } else if (light.isDirectionalLight) {
            lux = () => level * -aim[2] / Math.hypot(...aim);
        } else if (light.iesMap) {
            light.shadow.updateMatrices(light);
            const { data, width, height } = light.iesMap.image;
            const texel = (i, j) => DataUtils.fromHalfFloat(data[(((j % height) + height) % height) * width + Math.min(i, width - 1)]);
            lux = punctual(position, (away) => {
                // The shadow's coordinates of a point in front of the light.
                const far = light.shadow.matrix.elements;
                const p = [position[0] + away[0], position[2] + away[2], -position[1] - away[1], 1];
                const row = (k) => far[k] * p[0] + far[4 + k] * p[1] + far[8 + k] * p[2] + far[12 + k];
                const [u, v] = [row(0) / row(3) - 0.5, row(1) / row(3) - 0.5];
                const twist = (Math.atan2(v, u) + Math.PI) / (2 * Math.PI) * height;
                const gamma = Math.acos(dot(away, aim) / Math.hypot(...away) / Math.hypot(...aim)) * 180 / Math.PI;
                const [i, j] = [Math.floor(gamma), Math.floor(twist)];
                const of = (k) => texel(i, k) + (gamma - i) * (texel(i + 1, k) - texel(i, k));
                return level * (of(j) + (twist - j) * (of(j + 1) - of(j)));
            });
        } else if (light.isSpotLight) {
            const [outer, inner] = [Math.cos(light.angle), Math.cos(light.angle * (1 - light.penumbra))];
            lux = punctual(position, (away) => level * smoothstep(
                (dot(away, aim) / Math.hypot(...away) / Math.hypot(...aim) - outer) / (inner - outer)));
        } else {
            lux = punctual(position, () => level);
        }
        list.push({ name: light.name, lux });
    }
} else {
    const { NullEngine } = await import('@babylonjs/core/Engines/nullEngine.js');
    const { Scene } = await import('@babylonjs/core/scene.js');
    const world = (v) => [v.x, v.z, v.y];
    for (const light of makeLights(new Scene(new NullEngine()))) {
        const level = dot([light.diffuse.r, light.diffuse.g, light.diffuse.b], luminance) * light.intensity;
        const position = world(light.position);
        const aim = light.direction ? world(light.direction) : null;
        const cosine = (away) => dot(away, aim) / Math.hypot(...away) / Math.hypot(...aim);
        const kind = light.getClassName();
        if (light.iesProfileTexture) continue; // azimuths are lost
        if (kind === 'RectAreaLight') continue; // tests/programs renders it
        list.push({ name: light.name, lux:
            kind === 'DirectionalLight' ? () => level * -aim[2] / Math.hypot(...aim)
                : kind === 'SpotLight' ? punctual(position, (away) => {
                    const [outer, inner] = [Math.cos(light.angle / 2), Math.cos(light.innerAngle / 2)];
                    const x = Math.min(Math.max((cosine(away) - outer) / (inner - outer), 0), 1);
                    return level * x * x;
                })
                    : punctual(position, () => level) });
    }
}

let bad = 0;
let count = 0;
for (const { name, lux } of list) {
    if (truth[0].lights[name] === undefined) continue;
    const brightest = Math.max(...truth.map((one) => one.lights[name]));
    const worst = Math.max(...truth.map((one) => Math.abs(lux(one.position) - one.lights[name]))) / brightest;
    ++count;
    // What a sphere, a disk, an ellipse and a tube are from near, a point is not.
    const allowed = name === 'bulb' ? 0.02 : name === 'disk' || name === 'ellipse' || name === 'tube' ? 0.2 : 0.01;
    if (!(worst < allowed)) { console.log(`  ${name} is off by ${worst}`); ++bad; }
}
console.log(`${program}: ${count} lights at ${truth.length} points`);
process.exit(bad === 0 && count > 3 ? 0 : 1);
