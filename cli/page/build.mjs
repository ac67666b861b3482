// Builds the page: one HTML file that holds everything, so that it opens from a disk, a server or a mail.
//   node cli/page/build.mjs GONIO_PAGE_MJS OUTPUT_HTML
//
// GONIO_PAGE_MJS is the module of cli/wasm with what the page calls; gonio.mjs, with everything, works too. Its WebAssembly is
// taken out of its text, and compiled once by one of the page's workers for all of them. The modules of this folder are joined into
// one script: each imports and exports by name only, and no two have a top-level name in common, which is checked. The same inputs
// give the same bytes.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Script } from 'node:vm';

const here = dirname(fileURLToPath(import.meta.url));
const examples = ['downlight.ies', 'street.ldt'];

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}

const [modulePath, outputPath] = process.argv.slice(2);
if (!modulePath || !outputPath) fail('usage: node build.mjs GONIO_PAGE_MJS OUTPUT_HTML');

// The text of a script must not end its element, nor open a comment of HTML.
const inScript = (text) => text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
const inJson = (value) => JSON.stringify(value).replace(/</g, '\\u003c');

// The module's JavaScript, and its WebAssembly apart from it.
function splitModule(path) {
  let glue = readFileSync(path, 'utf8');
  let wasm;
  glue = glue.replace(/(= withWebAssembly\(\w+, ")([A-Za-z0-9+/=]+)/, (_, call, packed) => {
    wasm = packed;
    return call;
  });
  if (!wasm) fail(`${path} holds no WebAssembly`);
  glue = glue.replace(/export default (async function (\w+)|\w+;?\s*$)/m, (_, what, name) =>
    (name ? `self.createGonio = ${name};\n${what}` : `self.createGonio = ${what}`)).replaceAll('import.meta.url', 'self.location.href');
  if (!glue.includes('self.createGonio')) fail(`${path} has no default export`);
  return { glue, wasm };
}

// The modules in the order in which they need one another, without their imports and exports.
function joinModules(entry) {
  const done = new Set();
  const owners = new Map();
  const parts = [];
  const visit = (name) => {
    if (done.has(name)) return;
    done.add(name);
    const text = readFileSync(join(here, name), 'utf8');
    const body = text.replace(/^import\s+\{[^}]*\}\s+from\s+'\.\/([\w.-]+)';\n/gm, (line, needed) => {
      if (/ as /.test(line)) fail(`${name}: an import under another name`);
      visit(needed);
      return '';
    });
    if (/^(import|export default|export \{|export \*)/m.test(body)) fail(`${name}: only named imports and exports of declarations`);
    for (const [, declared] of body.matchAll(/^(?:export )?(?:async )?(?:function\*?|const|let|class) +(\w+)/gm)) {
      if (owners.has(declared)) fail(`${name} and ${owners.get(declared)} both declare ${declared}`);
      owners.set(declared, name);
    }
    parts.push(`// ${name}\n${body.replace(/^export /gm, '')}`);
  };
  visit(entry);
  const joined = `'use strict';\n${parts.join('\n')}`;
  new Script(joined, { filename: entry }); // throws on what is no script
  return joined;
}

const { glue, wasm } = splitModule(resolve(modulePath));
const profiles = examples.map((name) => ({ name, text: readFileSync(join(here, '../../profiles', name), 'latin1') }));
// Glue that makes functions out of text (Emscripten without -sDYNAMIC_EXECUTION=0) needs a policy that lets it.
const makesFunctions = /\bnew Function\b|new_\(Function\b/.test(glue);
if (makesFunctions) console.warn(`warning: ${modulePath} makes functions out of text: the policy of the page allows 'unsafe-eval'`);
const pieces = {
  EVAL: makesFunctions ? " 'unsafe-eval'" : '',
  STYLE: readFileSync(join(here, 'style.css'), 'utf8'),
  SCRIPT: inScript(joinModules('main.mjs')),
  WORKER: inScript(`'use strict';\n${glue}\n${readFileSync(join(here, 'worker.js'), 'utf8')}`),
  WASM: wasm,
  EXAMPLES: inJson(profiles),
};
const html = readFileSync(join(here, 'index.html'), 'utf8').replace(/\/\*\*([A-Z]+)\*\*\//g, (_, name) => {
  if (!(name in pieces)) fail(`index.html asks for ${name}`);
  return pieces[name];
});
mkdirSync(dirname(resolve(outputPath)), { recursive: true });
writeFileSync(outputPath, html);
console.log(`${outputPath}: ${html.length} bytes, of which ${pieces.WASM.length} are WebAssembly`);
