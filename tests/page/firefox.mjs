// The page in headless Firefox: what is dropped is measured as the tool measures it, drawn and lit, and nothing complains. Run by
// run.sh.
//   node firefox.mjs BUILD_FOLDER GONIO
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [build, tool] = process.argv.slice(2).map((path) => resolve(path));
const need = createRequire(join(build, 'package.json'));
const { default: puppeteer } = await import(pathToFileURL(need.resolve('puppeteer-core')));
const profiles = join(dirname(fileURLToPath(import.meta.url)), '../../profiles');

const browser = await puppeteer.launch({ browser: 'firefox', executablePath: '/usr/bin/firefox-esr', headless: true });
const tab = await browser.newPage();
const noise = [];
tab.on('console', (message) => ['error', 'warn', 'warning', 'assert'].includes(message.type()) && noise.push(`${message.type()}: ${message.text()}`));
tab.on('pageerror', (error) => noise.push(`uncaught: ${error.message}`));
await tab.setViewport({ width: 1280, height: 900 });
await tab.goto(pathToFileURL(join(build, 'gonio.html')).href);
await tab.waitForFunction(() => document.body.dataset.warm, { timeout: 90000 });
const ready = Number(await tab.evaluate(() => document.body.dataset.ready));

const whole = readFileSync(join(profiles, 'downlight.ies'));
const given = [['street.ldt', readFileSync(join(profiles, 'street.ldt'))], ['downlight.ies', whole], ['cut.ies', whole.subarray(0, 800)]];
await tab.evaluate((list) => {
  const transfer = new DataTransfer();
  for (const [name, base64] of list) transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
  dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, given.map(([name, bytes]) => [name, bytes.toString('base64')]));
await tab.waitForFunction(() => document.querySelector('.stage').dataset.firstPicture, { timeout: 90000 });
const first = Number(await tab.evaluate(() => document.querySelector('.stage').dataset.firstPicture));
await tab.waitForFunction(() => [...document.querySelectorAll('.file .facts')].filter((each) => each.textContent !== 'reading…').length === 3, { timeout: 90000 });

for (const [i, [name]] of given.slice(0, 2).entries()) {
  await tab.evaluate((n) => document.querySelectorAll('.file-name')[n].click(), i);
  await tab.waitForFunction((title) => document.querySelector('.file-title').textContent === title && document.querySelector('.facts-table'), {}, name);
  const shown = await tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('.facts-card [data-key]')].map((cell) => [cell.dataset.key, JSON.parse(cell.dataset.raw)])));
  const expected = JSON.parse(execFileSync(tool, ['info', '--json', join(profiles, name)], { encoding: 'utf8' }));
  for (const key of ['flux_lm', 'peak_cd', 'beam_angle_deg', 'photometry'])
    if (typeof expected[key] === 'number' || typeof expected[key] === 'string') assert.equal(shown[key], expected[key], `${name}: ${key}`);
}
for (const kind of ['polar', 'isolux', 'solid']) {
  await tab.evaluate((value) => document.querySelector(`.diagram-card [data-value="${value}"]`).click(), kind);
  await tab.waitForFunction((value) => document.querySelector('.diagram-card').dataset.ready.endsWith(` ${value}`), { timeout: 90000 }, kind);
}
await tab.waitForFunction(() => document.querySelector('.stage').dataset.quality === 'refined', { timeout: 180000 });
await tab.screenshot({ path: join(build, 'firefox-profile.png') });

// The light moves by a key, and the picture follows.
await tab.evaluate(() => document.getElementById('tab-stage').click());
await tab.focus('.stage-box canvas');
const shown = await tab.evaluate(() => Number(document.querySelector('.stage').dataset.shown));
await tab.keyboard.down('Shift');
await tab.keyboard.press('ArrowRight');
await tab.keyboard.up('Shift');
await tab.waitForFunction((n) => Number(document.querySelector('.stage').dataset.shown) > n, { timeout: 60000 }, shown);
await tab.waitForFunction(() => document.querySelector('.stage').dataset.quality === 'refined', { timeout: 180000 });
await tab.screenshot({ path: join(build, 'firefox-stage.png') });

await tab.evaluate(() => document.querySelectorAll('.file-name')[2].click());
await tab.evaluate(() => document.getElementById('tab-profile').click());
await tab.waitForFunction(() => document.querySelector('.finding .code'), { timeout: 60000 });
assert.deepEqual(noise, [], 'the console');
console.log(`${await browser.version()}: ready after ${Math.round(ready)} ms, first picture ${Math.round(first)} ms after the drop; numbers, diagrams and the stage work`);
await browser.close();
