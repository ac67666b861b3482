// The lookups of tables in WGSL (`gonio bake --table`), compiled in headless Chromium, whose compiler is tint. What they
// compute is checked by tests/tables/reread.py. Run by run.sh.
//   node lookups.mjs WORK_FOLDER GONIO
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const work = resolve(process.argv[2]);
const tool = resolve(process.argv[3]);
const need = createRequire(join(work, 'package.json'));
const { default: puppeteer } = await import(pathToFileURL(need.resolve('puppeteer-core')));
const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan,WebGPU'] });
const tab = await browser.newPage();
await tab.goto(pathToFileURL(join(work, 'empty.html')).href);

async function messages(code) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) throw new Error('no WebGPU');
  const device = await adapter.requestDevice();
  const info = await device.createShaderModule({ code }).getCompilationInfo();
  return info.messages.map((each) => `${each.lineNum}: ${each.message}`);
}

let count = 0;
for (const words of [['dfg'], ['dfg', '--form', 'chebyshev'], ['kulla-conty', '--pixel', 'uint8'], ['ltc-ggx', '--pixel', 'half'], ['ltc-disney'], ['ltc-disney', '--form', 'chebyshev'], ['ltc-heitz', '--pixel', 'half']]) {
  const file = join(work, 'table.json');
  execFileSync(tool, ['bake', '--table', ...words, '-s', '8', '-o', file]);
  const { table, form, layers, channels, lookup } = JSON.parse(readFileSync(file, 'utf8'));
  const texture = form === 'chebyshev' ? '' : `@group(0) @binding(0) var table: texture_2d${layers.length > 1 ? '_array' : ''}<f32>;\n@group(0) @binding(1) var held: sampler;\n`;
  const call = `${table.replaceAll('-', '_')}_lookup(${texture && 'table, held, '}at.x, at.y).${(table === 'ltc-heitz' ? channels[5] : channels.at(-1)).name}`;
  const found = await tab.evaluate(messages, `${lookup.wgsl}\n${texture}@fragment\nfn main(@location(0) at: vec2<f32>) -> @location(0) vec4<f32> {\n    return vec4<f32>(${call});\n}\n`);
  assert.deepEqual(found, [], words.join(' '));
  count += 1;
}
await browser.close();
console.log(`\n${count} lookups of tables compile in WGSL`);
