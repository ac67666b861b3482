// node join.mjs MODULE SCRIPT OUTPUT: the module that Emscripten wrote, which is no longer exported itself, and the script.
import { readFileSync, writeFileSync } from 'node:fs';

const [module, script, output] = process.argv.slice(2);
const text = readFileSync(module, 'utf8');
const own = text.replace(/export default \w+;\s*$/, '');
if (own === text) throw new Error(`${module} does not end with its export`);
writeFileSync(output, own + readFileSync(script, 'utf8'));
