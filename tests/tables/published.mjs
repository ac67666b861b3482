// Writes the tables of three.js as halves, little-endian: ltc_1.half and ltc_2.half (64 × 64 × 4, the table of Heitz,
// Dupuy, Hill and Neubelt) and dfg.half (16 × 16 × 2). FOLDER has the npm package three in node_modules.
//   node published.mjs FOLDER
import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const folder = resolve(process.argv[2]);
const three = join(folder, 'node_modules', 'three');
const { RectAreaLightTexturesLib } = await import(pathToFileURL(join(three, 'examples/jsm/lights/RectAreaLightTexturesLib.js')).href);
RectAreaLightTexturesLib.init();
const save = (name, halves) => writeFileSync(join(folder, name), Buffer.from(Uint16Array.from(halves).buffer));
for (const layer of ['1', '2']) save(`ltc_${layer}.half`, RectAreaLightTexturesLib[`LTC_HALF_${layer}`].image.data);
const dfg = readFileSync(join(three, 'src/renderers/shaders/DFGLUTData.js'), 'utf8').match(/Uint16Array\( \[([^\]]*)\]/)[1];
save('dfg.half', dfg.split(',').map((each) => Number(each.trim())));
