// node build.mjs GONIO_MJS FOLDER: the package as a folder, for `npm pack` and `npm install`.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { areaLightData } from './area_light_data.mjs';

const [module, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
const version = /GONIO_VERSION_STRING "([^"]+)"/.exec(readFileSync(join(root, 'lib/gonio/base/version.hpp'), 'utf8'))[1];

mkdirSync(folder, { recursive: true });
const description = JSON.parse(readFileSync(join(here, 'package.json'), 'utf8'));
writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ ...description, version }, null, 2)}\n`);
for (const name of ['index.mjs', 'index.d.ts', 'three.mjs', 'three.d.ts', 'three-area-lights.mjs', 'three-area-lights.d.ts', 'babylon.mjs', 'babylon.d.ts', 'README.md'])
  copyFileSync(join(here, name), join(folder, name));
// Without what lies outside the package.
writeFileSync(join(folder, 'AREA_LIGHTS.md'), readFileSync(join(here, 'AREA_LIGHTS.md'), 'utf8').replaceAll(/!\[[^\]]*\]\(\.\.[^)]*\)\n\n\*[^\n]*\*\n\n/g, '').replaceAll(/\[([^\]]+)\]\(\.\.[^)]*\)/g, '$1'));
copyFileSync(join(root, 'LICENSE'), join(folder, 'LICENSE'));
copyFileSync(module, join(folder, 'gonio.mjs'));
// The tool in the package prints what its area lights are made of.
const { default: createTool } = await import(pathToFileURL(resolve(module)).href);
const tool = await createTool();
writeFileSync(join(folder, 'area-light-data.mjs'), areaLightData((words) => {
  const result = tool.run(words, {});
  if (result.status !== 0) throw new Error(result.stderr);
  return { stdout: new TextDecoder().decode(result.stdout), files: result.files };
}));
