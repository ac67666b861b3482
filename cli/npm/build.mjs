// node build.mjs GONIO_MJS FOLDER: the package as a folder, for `npm pack` and `npm install`.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [module, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../..');
const version = /GONIO_VERSION_STRING "([^"]+)"/.exec(readFileSync(join(root, 'lib/gonio/base/version.hpp'), 'utf8'))[1];

mkdirSync(folder, { recursive: true });
const description = JSON.parse(readFileSync(join(here, 'package.json'), 'utf8'));
writeFileSync(join(folder, 'package.json'), `${JSON.stringify({ ...description, version }, null, 2)}\n`);
for (const name of ['index.mjs', 'index.d.ts', 'three.mjs', 'three.d.ts', 'babylon.mjs', 'babylon.d.ts', 'README.md'])
  copyFileSync(join(here, name), join(folder, name));
copyFileSync(join(root, 'LICENSE'), join(folder, 'LICENSE'));
copyFileSync(module, join(folder, 'gonio.mjs'));
