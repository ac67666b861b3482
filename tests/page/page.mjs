// The page in headless Chromium: what is dropped is measured as the tool measures it, nothing runs that came in a file, it
// is reachable by keys and readers, and it is quick. Run by run.sh.
//   node page.mjs BUILD_FOLDER GONIO CORPUS
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { decodePng } from '../wasm/png.mjs';
import { withoutFigures } from '../wasm/facts.mjs';

const [build, tool, corpus] = process.argv.slice(2).map((path) => resolve(path));
const need = createRequire(join(build, 'package.json'));
const { default: puppeteer } = await import(pathToFileURL(need.resolve('puppeteer-core')));
const axe = readFileSync(need.resolve('axe-core/axe.min.js'), 'utf8');
const profiles = join(dirname(fileURLToPath(import.meta.url)), '../../profiles');
const page = pathToFileURL(join(build, 'gonio.html')).href;
const figures = {};

const inFolder = (folder) => (existsSync(folder) ? readdirSync(folder).sort().map((name) => join(folder, name)) : []);
const ofTree = inFolder(profiles).filter((path) => /\.(ies|ldt|xml)$/.test(path));
const good = [...ofTree.slice(0, 12), ...inFolder(join(corpus, 'good')).filter((path) => /\.(ies|ldt)$/.test(path)).slice(0, 8), ...ofTree.slice(12)].slice(0, 20);

const nativeJson = (...words) => {
  try {
    return JSON.parse(execFileSync(tool, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
  } catch (error) {
    return JSON.parse(error.stdout);
  }
};
const noteStep = (text) => console.log(text);

// All facts are the tool's digit for digit, but for those that go through sines, cosines and their inverses, in which the C library of
// the module, musl, and the tool's, glibc, differ by an ulp: with these functions of musl in place of glibc's, the tool gives the
// digits of the module. Zones are differences of sums as large as the flux, or sums of such.
const ofTheCLibrary = {
  flux_lm: 'flux', zonal_flux_lm: 'flux', zones_lm: 'flux', lcs_lm: 'flux', cie_flux_code_percent: 'value', spacing_criterion: 'value',
  beam_angle_deg: 'value', beam_angle_c90_deg: 'value', field_angle_deg: 'value', field_angle_c90_deg: 'value',
  point_distance_m: 'value', light_output_ratios: 'value',
};

// Six files with something wrong, where there is no corpus of them.
mkdirSync(join(build, 'made'), { recursive: true });
const made = (name, bytes) => {
  const path = join(build, 'made', name);
  writeFileSync(path, bytes);
  return path;
};
const whole = readFileSync(join(profiles, 'downlight.ies'));
let broken = inFolder(join(corpus, 'bad')).filter((path) => /\.(ies|ldt)$/.test(path)).slice(0, 6);
if (broken.length < 6)
  broken = [made('cut.ies', whole.subarray(0, 800)), made('empty.ies', ''), made('binary.ldt', Buffer.from(Array.from({ length: 900 }, (_, i) => (i * 37) & 255))),
    made('words.ies', 'IESNA:LM-63-2002\nTILT=NONE\nthis is no number\n'), made('short.ldt', '1\n2\n3\n'), made('tree.xml', '<a><b></a>')];

// The page knows where the stages' lights and cameras are; the tool says where. glTF has Y up.
{
  const { anglesOf, directionOf, stages, subtract, unit } = await import('../../cli/page/stages.mjs');
  const turned = ([x, y, z, w], v) => {
    const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
  };
  const zUp = ([x, y, z]) => [x, -z, y];
  const near = (a, b, what) => a.forEach((value, i) => assert.ok(Math.abs(value - b[i]) < 1e-6, `${what}: ${a}, not ${b}`));
  assert.deepEqual(Object.keys(stages).sort(), nativeJson('list', 'stages', '--json').entries.map(({ name }) => name).sort());
  for (const [name, { camera, light, surfaces }] of Object.entries(stages)) {
    const path = join(build, `made/${name}.gltf`);
    execFileSync(tool, ['preview', '--shape', 'spot:outer=30deg', '--intensity', '800lm', '--stage', name, '-s', '600x400', '--export', path, '-q']);
    const { nodes, cameras } = JSON.parse(readFileSync(path, 'utf8'));
    const eye = nodes.find((node) => node.camera !== undefined);
    near(camera.position, zUp(eye.translation), `${name}: camera`);
    near(unit(subtract(camera.target, camera.position)), zUp(turned(eye.rotation, [0, 0, -1])), `${name}: view`);
    near([camera.fov], [(cameras[0].perspective.yfov * 180) / Math.PI], `${name}: field of view`);
    const lamp = nodes.find((node) => node.extensions?.KHR_lights_punctual);
    near(light.position, zUp(lamp.translation ?? [0, 0, 0]), `${name}: light`);
    near(light.direction ?? [0, 0, -1], zUp(turned(lamp.rotation ?? [0, 0, 0, 1], [0, 0, -1])), `${name}: direction`);
    assert.deepEqual(surfaces, [...new Set(nodes.filter((node) => node.mesh !== undefined).map((node) => node.name.replace(/_\d+$/, '')))], name);
  }
  near(directionOf(30, 40), [0.383022, 0.321394, -0.866025], 'direction');
  near([anglesOf([0, 1, 0]).tilt, anglesOf([0, 1, 0]).azimuth], [90, 90], 'angles');
  noteStep('stages are as the tool has them');
}

const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true, args: ['--no-sandbox', '--force-device-scale-factor=1'] });
const noise = [];

async function openPage({ width = 1280, height = 900, dark = false, url = page } = {}) {
  const tab = await browser.newPage();
  tab.on('console', (message) => {
    if (['error', 'warn', 'warning', 'assert'].includes(message.type())) noise.push(`${message.type()}: ${message.text()}`);
  });
  tab.on('pageerror', (error) => noise.push(`uncaught: ${error.message}`));
  tab.on('dialog', (dialog) => {
    noise.push(`a dialog opened: ${dialog.message()}`);
    dialog.dismiss();
  });
  tab.on('request', (request) => {
    if (!/^(file|blob|data|about):/.test(request.url())) noise.push(`request to ${request.url()}`);
  });
  await tab.setViewport({ width, height });
  await tab.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }]);
  await tab.goto(url);
  await tab.waitForFunction(() => document.body.dataset.warm, { timeout: 90000 });
  return tab;
}

// As a drop does it: with files in a DataTransfer.
async function drop(tab, paths) {
  const given = paths.map((path) => ({ name: typeof path === 'string' ? basename(path) : path.name, base64: (typeof path === 'string' ? readFileSync(path) : Buffer.from(path.text)).toString('base64') }));
  await tab.evaluate((list) => {
    const transfer = new DataTransfer();
    for (const { name, base64 } of list) transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, given);
}

const listed = (tab) => tab.evaluate(() => [...document.querySelectorAll('.file')].map((item) => ({ name: item.querySelector('.name').textContent, facts: item.querySelector('.facts').textContent, badge: item.querySelector('.badge')?.textContent ?? '' })));
const allRead = (tab, count) => tab.waitForFunction((n) => {
  const facts = [...document.querySelectorAll('.file .facts')];
  return facts.length === n && facts.every((each) => each.textContent !== 'reading…');
}, { timeout: 120000 }, count);
const choose = (tab, index) => tab.evaluate((i) => document.querySelectorAll('.file-name')[i].click(), index);
const refined = (tab) => tab.waitForFunction(() => document.querySelector('.stage').dataset.quality === 'refined', { timeout: 180000 });
async function quiet(tab, what) {
  assert.deepEqual(noise.splice(0), [], `${what}: the console`);
}

async function noViolations(tab, what) {
  await tab.evaluate(axe);
  const { violations } = await tab.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160)).slice(0, 3).join(' | ')} ${nodes[0].failureSummary}`);
  assert.deepEqual(found, [], `${what}: axe`);
}

// ---- ready, first picture

{
  const times = [];
  const firsts = [];
  for (let i = 0; i < 3; ++i) {
    const tab = await openPage();
    times.push(Number(await tab.evaluate(() => document.body.dataset.ready)));
    await drop(tab, [join(profiles, 'street.ldt')]);
    await tab.waitForFunction(() => document.querySelector('.stage').dataset.firstPicture, { timeout: 90000 });
    firsts.push(Number(await tab.evaluate(() => document.querySelector('.stage').dataset.firstPicture)));
    await tab.close();
  }
  figures.ready_ms = times;
  figures.first_picture_ms = firsts;
  await quiet(undefined, 'start');
  noteStep(`ready after ${times.map(Math.round).join(', ')} ms; first picture ${firsts.map(Math.round).join(', ')} ms after the drop`);
}

const tab = await openPage({ width: 1440, height: 1000 });
await tab.screenshot({ path: join(build, 'empty.png') });
await noViolations(tab, 'empty page');

// ---- twenty good files and six broken ones

await drop(tab, [...good, ...broken]);
await allRead(tab, good.length + broken.length);
{
  const list = await listed(tab);
  assert.equal(list.length, good.length + broken.length);
  for (const [i, path] of [...good, ...broken].entries()) {
    await choose(tab, i);
    assert.equal(list[i].name, basename(path));
    const checked = nativeJson('check', '--json', path);
    if (checked.readable) {
      await tab.waitForFunction((name) => document.querySelector('.file-title').textContent === name && document.querySelector('.facts-table'), {}, basename(path));
      const shown = await tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('.facts-card [data-key]')].map((cell) => [cell.dataset.key, { raw: JSON.parse(cell.dataset.raw), text: cell.querySelector('.number')?.textContent }])));
      const whole = nativeJson('info', '--json', '--all', path);
      const expected = withoutFigures(whole);
      const isSame = (value, key) => {
        const scale = { flux: expected.flux_lm, value: Math.abs(value) }[ofTheCLibrary[key.split('.')[0]]];
        if (scale && typeof value === 'number') assert.ok(Math.abs(shown[key].raw - value) <= 1e-15 * scale, `${path}: ${key}: ${shown[key].raw}, not ${value}`);
        else assert.equal(shown[key].raw, value, `${path}: ${key}`);
      };
      const seen = (value, key) => {
        if (value === null || value === '') return;
        if (typeof value === 'object') {
          for (const [name, each] of Object.entries(value)) seen(each, `${key}.${name}`);
          return;
        }
        assert.ok(key in shown, `${path}: ${key} is not shown`);
        isSame(value, key);
        if (typeof value === 'number') assert.equal(Number(shown[key].text), shown[key].raw, `${path}: text of ${key}`);
      };
      for (const [key, value] of Object.entries(expected))
        if (!['schema', 'file', 'diagnostics', 'ten_degree_zones_lm'].includes(key)) seen(value, key);
      // Of the figures those with one value, and the tables.
      for (const key of ['light_output_ratios.lor', 'distribution_class', 'bug.rating', 'cut_off', 'luminous_intensity_class', 'glare_index.class']) {
        const value = key.split('.').reduce((part, name) => part?.[name], whole) ?? null;
        isSame(value, key);
      }
      const cells = await tab.evaluate(() => [...document.querySelectorAll('.figure-table table')].map((table) => table.querySelectorAll('tbody td').length));
      assert.deepEqual(cells, [...(whole.ugr_table ? [190] : []), ...(whole.utilisation_factors ? [80] : [])], `${path}: tables of figures`);
    }
    // Findings: code, place and sentence.
    await tab.waitForFunction((n) => n === 0 ? document.querySelector('.findings-card .ok') : document.querySelectorAll('.finding').length >= Math.min(n, 50), { timeout: 90000 }, checked.diagnostics.length);
    const found = await tab.evaluate(() => [...document.querySelectorAll('.finding')].map((item) => [item.querySelector('.code').textContent, item.querySelector('.where')?.textContent ?? '', item.querySelector('.message').textContent].join(' ')));
    const expectedFindings = checked.diagnostics.map(({ code, line, column, message }) => [code, line ? `${line}:${column}` : '', message].join(' '));
    if (expectedFindings.length <= 50) {
      const clean = (text) => text.replaceAll(path, 'FILE').replaceAll(basename(path), 'FILE');
      assert.deepEqual(found.map(clean).sort(), expectedFindings.map(clean).sort(), path);
    }
    if (!checked.readable) assert.match(list[i].badge, /unreadable/);
  }
  await quiet(tab, 'good and broken files');
  noteStep(`${good.length} profiles and ${broken.length} broken files: numbers and findings as the tool's`);
}

// ---- the views

await choose(tab, 0);
await refined(tab);
for (const kind of ['polar', 'cartesian', 'heat-map', 'isolux', 'cone', 'solid']) {
  await tab.evaluate((value) => document.querySelector(`.diagram-card [data-value="${value}"]`).click(), kind);
  await tab.waitForFunction((value) => document.querySelector('.diagram-card').dataset.ready.endsWith(` ${value}`), { timeout: 90000 }, kind);
  if (kind !== 'solid') await tab.waitForFunction(() => document.querySelector('.diagram-card img').complete && document.querySelector('.diagram-card img').naturalWidth > 0);
  await (await tab.$('.diagram-card')).screenshot({ path: join(build, `diagram-${kind}.png`) });
}
await tab.screenshot({ path: join(build, 'profile.png'), fullPage: true });
await choose(tab, good.length);
await tab.evaluate(() => document.querySelector('.finding .code').click());
await tab.waitForFunction(() => document.querySelector('.finding .meaning p'));
await tab.screenshot({ path: join(build, 'broken.png') });
await choose(tab, 0);
await quiet(tab, 'diagrams');

const goTo = (name, on = tab) => on.evaluate((id) => document.getElementById(`tab-${id}`).click(), name);
await goTo('stage');
await refined(tab);
await tab.screenshot({ path: join(build, 'stage.png'), fullPage: true });

// Pictures per second while the camera goes around.
{
  const box = await (await tab.$('.stage-box canvas')).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.evaluate(() => {
    globalThis.counted = [];
    document.querySelector('.stage').addEventListener('picture', ({ detail }) => globalThis.counted.push([performance.now(), detail.width, detail.height, detail.ms]));
  });
  const begin = Date.now();
  for (let i = 0; Date.now() - begin < 4000; ++i) {
    await tab.mouse.move(x + 150 * Math.sin(i / 40), y + 20 * Math.sin(i / 25));
    await new Promise((done) => setTimeout(done, 8));
  }
  const counted = await tab.evaluate(() => globalThis.counted);
  await tab.mouse.up();
  const late = counted.filter(([at]) => at > counted[0][0] + 1500);
  const rate = (1000 * (late.length - 1)) / (late.at(-1)[0] - late[0][0]);
  figures.orbit = { pictures_per_second: rate, size: `${late.at(-1)[1]} x ${late.at(-1)[2]}`, render_ms: late.reduce((sum, each) => sum + each[3], 0) / late.length };
  noteStep(`orbiting: ${rate.toFixed(1)} pictures a second at ${figures.orbit.size}, ${figures.orbit.render_ms.toFixed(1)} ms each`);
  await refined(tab);
}

// Keys: the light moves, is undone and done again.
{
  await tab.focus('.stage-box canvas');
  const where = () => tab.evaluate(() => [...document.querySelectorAll('.panel .three input')].map((input) => Number(input.value)));
  const before = await where();
  await tab.keyboard.down('Shift');
  await tab.keyboard.press('ArrowRight');
  await tab.keyboard.up('Shift');
  const moved = await where();
  assert.ok(Math.abs(moved[0] - before[0] - 0.05) < 1e-9, `moved from ${before} to ${moved}`);
  await tab.keyboard.down('Control');
  await tab.keyboard.press('z');
  await tab.keyboard.up('Control');
  assert.deepEqual(await where(), before);
  await tab.keyboard.press('r');
  await refined(tab);
}

// Lux at a pixel: as `gonio probe` has it nearby. Here: a number and its unit.
{
  const box = await (await tab.$('.stage-box canvas')).boundingBox();
  await tab.mouse.move(box.x + box.width / 2, box.y + box.height * 0.9);
  await tab.waitForFunction(() => / lx · .* cd\/m²$/.test(document.querySelector('.readout').textContent), { timeout: 60000 });
}

for (const mode of ['falsecolour', 'isolux']) {
  await tab.evaluate((value) => document.querySelector(`.panel [data-value="${value}"]`).click(), mode);
  await tab.waitForFunction(() => document.querySelector('.stage').dataset.quality === 'moving', { timeout: 60000 }).catch(() => {});
  await refined(tab);
  if (mode === 'isolux') {
    const [label, marks] = await tab.evaluate(() => [document.querySelector('.legend').getAttribute('aria-label'), document.querySelectorAll('.legend.lines:not([hidden]) .legend-mark').length]);
    assert.match(label, /^Lines of equal illuminance: [\d., ]+ lx$/);
    assert.equal(marks, label.split(',').length);
  }
  await tab.screenshot({ path: join(build, `stage-${mode}.png`) });
}
await tab.evaluate(() => document.querySelector('.panel [data-value="beauty"]').click());
// A moving picture and a full one, which comes in three steps of at most 120 s.
const redrawn = async (change) => {
  const shown = await tab.evaluate(() => Number(document.querySelector('.stage').dataset.shown));
  await change();
  await tab.waitForFunction((n) => Number(document.querySelector('.stage').dataset.shown) > n + 1 && document.querySelector('.stage').dataset.quality === 'refined', { timeout: 400000 }, shown);
};
await tab.setViewport({ width: 1120, height: 760 }); // the full pictures of `spheres` take long
for (const stage of ['floor', 'wall', 'corridor', 'street', 'spheres', 'card', 'room']) {
  await redrawn(() => tab.evaluate((name) => {
    const select = [...document.querySelectorAll('.panel select')].find((each) => [...each.options].some((option) => option.value === 'corridor'));
    select.value = name;
    select.dispatchEvent(new Event('change'));
  }, stage));
  assert.equal(await tab.evaluate(() => document.querySelector('.stage-errors').textContent), '', stage);
  await (await tab.$('.stage-box')).screenshot({ path: join(build, `stage-${stage}.png`) });
}
await quiet(tab, 'the stage');

// The full picture is the tool's, pixel for pixel: of the rig that the page saves, with vectors of the same width. Rounding and
// dithering may fall on either side.
{
  const { stages } = await import('../../cli/page/stages.mjs');
  const folder = join(build, 'made/scene');
  rmSync(folder, { recursive: true, force: true });
  await goTo('export');
  const zip = await tab.evaluate(async () => {
    const make = URL.createObjectURL;
    const { click } = HTMLAnchorElement.prototype;
    let blob;
    URL.createObjectURL = (given) => make.call(URL, blob = given);
    HTMLAnchorElement.prototype.click = () => {};
    [...document.querySelectorAll('#panel-export button')].find((button) => button.textContent === 'Save the rig').click();
    await new Promise((done) => setTimeout(done, 300));
    Object.assign(URL, { createObjectURL: make });
    HTMLAnchorElement.prototype.click = click;
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
  writeFileSync(join(build, 'made/scene.zip'), Buffer.from(zip));
  execFileSync('python3', ['-m', 'zipfile', '-e', join(build, 'made/scene.zip'), folder]);
  await redrawn(() => goTo('stage'));
  const { width, height, rgba } = await tab.evaluate(() => {
    const canvas = document.querySelector('.stage-box canvas');
    const { width, height } = canvas;
    return { width, height, rgba: [...canvas.getContext('2d').getImageData(0, 0, width, height).data] };
  });
  const { position, target } = stages.room.camera;
  execFileSync(tool, ['preview', '--rig', join(folder, 'scene.rig.json'), `--camera=${position}`, `--target=${target}`, '--view', 'Standard',
    '--simd', nativeJson('list', 'simd', '--json').entries.some(({ name }) => name === 'sse2') ? 'sse2' : 'neon',
    '-s', `${width}x${height}`, '-o', join(folder, 'native.png'), '-q']);
  const native = decodePng(readFileSync(join(folder, 'native.png')));
  assert.deepEqual([native.width, native.height, native.depth, native.color], [width, height, 8, 2]);
  let off = 0;
  native.pixels.forEach((value, i) => {
    if (Math.abs(value - rgba[4 * Math.floor(i / 3) + (i % 3)]) > 2) ++off;
  });
  assert.ok(off <= 0.001 * native.pixels.length, `${off} of ${native.pixels.length} values of the picture are not the tool's`);
  assert.ok(native.pixels.some((value) => value > 60), 'the stage is lit');
  figures.pixels_off = off / native.pixels.length;
  noteStep(`the picture of ${width} x ${height} is the tool's: ${off} of ${native.pixels.length} values differ by more than 2`);
  await quiet(tab, 'pixels');
}
noteStep('stages, display modes, keys and undo work');

// A full picture of half the light follows from the one before and is exposed by one stop more: of a globe, and of a profile with
// an opening. One of a light elsewhere is rendered.
for (const [name, light] of Object.entries({ globe: { shape: 'sphere:r=10cm', intensity: '800lm', position: [0, 0.3, 2.3] }, luminaire: { shape: `ies:${basename(good[0])}`, position: [0, 0.3, 2.3] } })) {
  const each = await openPage();
  await drop(each, [good[0], { name: 'one.json', text: JSON.stringify({ schema: 'gonio.rig/1', stage: 'room', lights: [light] }) }]);
  await goTo('stage', each);
  await refined(each);
  await new Promise((done) => setTimeout(done, 1500));
  // The first full picture after a field of the panel gets a value.
  const pictureAfter = (label, value) => each.evaluate((selector, given) => new Promise((done) => {
    const stage = document.querySelector('.stage');
    const take = ({ detail: { ms, ev100, rendered, width } }) => {
      if (stage.dataset.quality !== 'refined') return;
      stage.removeEventListener('picture', take);
      done({ ms, ev100, rendered, width });
    };
    stage.addEventListener('picture', take);
    const field = document.querySelector(selector);
    field.value = given;
    for (const kind of ['input', 'change']) field.dispatchEvent(new Event(kind));
  }), label, value);
  const bright = await each.evaluate(() => Number(document.querySelector('.panel [aria-label="Exposure"]').value));
  const { ms, ev100, rendered, width } = await pictureAfter('.panel input[type=range][aria-label="Dimming"]', 50);
  assert.equal(rendered, false, `${name}: the full picture of half the light is rendered again`);
  assert.equal(width, await each.evaluate(() => document.querySelector('.stage-box canvas').width), name);
  assert.ok(Math.abs(ev100 - (bright - 1)) < 0.06, `${name}: half the light is exposed by EV100 ${ev100}, all of it by ${bright}`);
  const moved = await pictureAfter('.panel .three input', 0.2);
  assert.equal(moved.rendered, true, `${name}: the full picture of a light that moved`);
  figures[`${name}_dimmed_ms`] = ms;
  figures[`${name}_moved_ms`] = moved.ms;
  await quiet(each, 'dimming');
  await each.close();
  noteStep(`dimming a ${name}: the full picture in ${ms.toFixed(1)} ms, of a light that moved in ${moved.ms.toFixed(1)} ms`);
}

// Arrays, groups and luminaires of a rig are lights of the page, where the tool has them.
{
  const each = await openPage();
  const rows = { schema: 'gonio.rig/1', stage: 'room', luminaires: { lamp: { shape: `ies:${basename(good[0])}` } }, lights: [
    { luminaire: 'lamp', name: 'row', position: [0, 0, 2.3], array: { count: [3, 1], spacing: [0.8, 1] } },
    { name: 'pair', position: [0, 1, 0], rotate: '90deg', lights: [{ shape: 'cylinder:r=3cm,l=30cm', intensity: '300lm', positions: [[0.5, 0, 2], [-0.5, 0, 2]], target: [0, 0, 0] }] },
  ] };
  await drop(each, [good[0], { name: 'rows.json', text: JSON.stringify(rows) }]);
  await goTo('stage', each);
  await each.waitForFunction(() => [...document.querySelectorAll('.panel .field')].find((field) => field.textContent.startsWith('Light'))?.querySelector('select').options.length === 5, { timeout: 60000 });
  await refined(each);
  assert.equal(await each.evaluate(() => document.querySelector('.stage-errors').textContent), '');
  const positions = [];
  for (let i = 0; i < 5; ++i) {
    await each.evaluate((value) => {
      const select = [...document.querySelectorAll('.panel .field')].find((field) => field.textContent.startsWith('Light')).querySelector('select');
      select.value = String(value);
      select.dispatchEvent(new Event('change'));
    }, i);
    positions.push(await each.evaluate(() => [...document.querySelectorAll('.panel .three input')].map((input) => Number(input.value))));
  }
  made(basename(good[0]), readFileSync(good[0]));
  const { lights: listed } = nativeJson('rig', 'list', made('rows.json', JSON.stringify(rows)), '--json');
  positions.forEach((position, i) => position.forEach((value, axis) => assert.ok(Math.abs(value - listed[i].position[axis]) < 0.006, `light ${i}: ${positions[i]}, not ${listed[i].position}`)));
  await new Promise((done) => setTimeout(done, 500)); // the picture of the light that was chosen last has begun
  await refined(each);
  await each.screenshot({ path: join(build, 'stage-rows.png') });
  // What cannot be opened says why.
  await drop(each, [{ name: 'wrong.json', text: JSON.stringify({ schema: 'gonio.rig/1', lights: [{ luminaire: 'none' }] }) }]);
  await each.waitForFunction(() => /luminaire/.test(document.getElementById('notice').textContent), { timeout: 60000 });
  await quiet(each, 'a rig of groups');
  await each.close();
  noteStep('arrays, groups and luminaires of a rig are its lights');
}

for (const name of ['compare', 'export', 'units', 'colour']) {
  await goTo(name);
  await new Promise((done) => setTimeout(done, 2500));
  await tab.screenshot({ path: join(build, `${name}.png`), fullPage: true });
}
{
  const shown = await tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('#panel-colour [data-key]')].map((cell) => [cell.dataset.key, cell.querySelector('.number')?.textContent])));
  const expected = nativeJson('cct', '3000K', '--json');
  assert.equal(Number(shown['xy.0']), expected.xy[0]);
  assert.equal(Number(shown['xy.1']), expected.xy[1]);
  const units = await tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('#panel-units [data-unit]')].map((cell) => [cell.dataset.unit, Number(cell.querySelector('.number').textContent)])));
  const expectedUnits = Object.fromEntries(nativeJson('units', '800lm', '--shape', 'sphere:r=3cm', '--json').results.map(({ unit, value }) => [unit, value]));
  for (const [unit, value] of Object.entries(expectedUnits)) assert.ok(Math.abs(units[unit] - value) <= 1e-15 * value, `${unit}: ${units[unit]}, ${value}`);
}
await quiet(tab, 'units and colour');

// ---- exports are the tool's bytes

{
  await goTo('export');
  await tab.waitForSelector('#panel-export .targets input', { timeout: 60000 }); // listed last, by the module
  await tab.evaluate(() => {
    globalThis.saved = [];
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => {
      globalThis.saved.push(blob);
      return make.call(URL, blob);
    };
    HTMLAnchorElement.prototype.click = function click() { globalThis.savedName = this.download; };
  });
  const saved = async (title) => {
    await tab.evaluate((text) => {
      globalThis.saved = [];
      [...document.querySelectorAll('#panel-export section')].find((section) => section.getAttribute('aria-label') === text).querySelector('button[type=submit]').click();
    }, title);
    const errors = (text) => [...document.querySelectorAll(`#panel-export section[aria-label="${text}"] .outcome .error`)].map((each) => each.textContent).join();
    await tab.waitForFunction((text) => globalThis.saved.length === 1 || document.querySelector(`#panel-export section[aria-label="${text}"] .outcome .error`), { timeout: 180000 }, title);
    assert.equal(await tab.evaluate(errors, title), '', title);
    return Buffer.from(await tab.evaluate(async () => [...new Uint8Array(await globalThis.saved[0].arrayBuffer())]));
  };
  await tab.evaluate(() => {
    const select = [...document.querySelectorAll('#panel-export select')].find((each) => [...each.options].some((option) => option.value === 'tm33'));
    select.value = 'ldt';
    select.dispatchEvent(new Event('change'));
  });
  const converted = await saved('Another format');
  execFileSync(tool, ['convert', good[0], '--to', 'ldt', '-o', join(build, 'made/converted.ldt'), '-q']);
  assert.ok(converted.equals(readFileSync(join(build, 'made/converted.ldt'))), 'convert');
  const zip = await saved('For engines and renderers');
  writeFileSync(join(build, 'made/assets.zip'), zip);
  const listing = execFileSync('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print("\\n".join(z.namelist()))', join(build, 'made/assets.zip')], { encoding: 'utf8' });
  assert.match(listing, /gltf\/.*\.glb/);
  await quiet(tab, 'exports');
  noteStep('conversion and zip are as the tool writes them');
}

// ---- a link brings the state back

{
  const link = await tab.evaluate(async () => {
    [...document.querySelectorAll('#panel-export button')].find((button) => button.textContent === 'Make a link').click();
    await new Promise((done) => setTimeout(done, 800));
    return document.querySelector('#panel-export input[readonly]').value;
  });
  assert.match(link, /#s=/);
  noise.splice(0);
  const other = await openPage({ url: link });
  await allRead(other, 1);
  assert.equal((await listed(other))[0].name, basename(good[0]));
  await other.close();
  figures.link_characters = link.length;
}

// A profile that a link has no room for is named.
{
  const each = await openPage();
  const lines = whole.toString('latin1').split(/\r?\n/);
  const noise = Array.from({ length: 3000 }, (_, i) => `[OTHER] ${Math.sin(i * i).toString(36)}${Math.cos(i * i).toString(36)}`);
  await drop(each, [{ name: 'large.ies', text: [lines[0], ...noise, ...lines.slice(1)].join('\r\n') }]);
  await allRead(each, 1);
  await goTo('export', each);
  const [link, said] = await each.evaluate(async () => {
    [...document.querySelectorAll('#panel-export button')].find((button) => button.textContent === 'Make a link').click();
    await new Promise((done) => setTimeout(done, 1500));
    return [document.querySelector('#panel-export input[readonly]').value, document.querySelector('#panel-export .outcome .ok').textContent];
  });
  assert.ok(link.length < 60000);
  assert.match(said, /but not large\.ies: a link has room for 60000 characters\./);
  await each.close();
  await quiet(undefined, 'a large link');
}
await tab.close();

// ---- nothing in a file runs

{
  const bad = '<img src=x onerror="alert(1)"><script>alert(2)</script><svg onload=alert(3)>';
  const keywords = ['TEST', 'TESTLAB', 'ISSUEDATE', 'MANUFAC', 'LUMCAT', 'LUMINAIRE', 'LAMP', 'LAMPCAT', 'OTHER', '_X', bad];
  const lines = whole.toString('latin1').split(/\r?\n/);
  const tilt = lines.findIndex((line) => line.startsWith('TILT'));
  const text = [lines[0], ...keywords.map((key) => `[${key}] ${bad}`), ...lines.slice(tilt)].join('\r\n');
  const hostile = await openPage();
  await drop(hostile, [{ name: `${bad}.ies`, text }, { name: '"><img src=x onerror=alert(4)>.ldt', text: bad.repeat(20) }, { name: 'x.xml', text: `<?xml version="1.0"?><!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]><a>&b;${bad}</a>` }]);
  await allRead(hostile, 3);
  await hostile.waitForFunction(() => document.querySelector('.keywords dd'));
  assert.equal(await hostile.evaluate(() => [...document.querySelectorAll('.keywords dd')].filter((each) => each.textContent.includes('onerror')).length), keywords.length);
  for (const name of ['stage', 'compare', 'export', 'profile']) await goTo(name, hostile);
  for (const i of [1, 2, 0]) {
    await choose(hostile, i);
    await new Promise((done) => setTimeout(done, 400));
  }
  assert.equal(await hostile.evaluate(() => document.querySelectorAll('main img:not(.diagram), main script, #files img, main svg').length), 0);
  await hostile.screenshot({ path: join(build, 'hostile.png') });
  await quiet(hostile, 'markup in files');
  await hostile.close();
  noteStep('markup in every keyword and in names stays text');
}

// ---- work without an end is ended

{
  const each = await openPage();
  const lights = Array.from({ length: 20000 }, (_, i) => ({ shape: 'rect:w=20cm,h=10cm', intensity: '10lm', position: [(i % 20) / 10 - 1, ((i / 20) % 20) / 10 - 1, 2.2] }));
  await drop(each, [good[0], { name: 'heavy.json', text: JSON.stringify({ schema: 'gonio.rig/1', stage: 'room', lights }) }]);
  await goTo('stage', each);
  await each.waitForFunction(() => !document.getElementById('cancel').hidden, { timeout: 90000 });
  const begin = Date.now();
  await each.keyboard.press('Escape');
  await each.waitForFunction(() => document.getElementById('cancel').hidden, { timeout: 20000 });
  await goTo('units', each);
  await each.waitForFunction(() => document.querySelector('#panel-units [data-unit]'), { timeout: 60000 });
  figures.cancel_ms = Date.now() - begin;
  await each.close();
  await quiet(undefined, 'cancel');
  noteStep('work without an end can be cancelled, and the page goes on');
}

// ---- readers, light and dark; widths

for (const dark of [false, true]) {
  const each = await openPage({ dark, width: 1440, height: 1000 });
  await drop(each, [good[0], good[13] ?? good[1], broken[0]]);
  await allRead(each, 3);
  await refined(each);
  for (const name of ['profile', 'stage', 'compare', 'export', 'units', 'colour']) {
    await goTo(name, each);
    await new Promise((done) => setTimeout(done, 1500));
    await noViolations(each, `${name}, ${dark ? 'dark' : 'light'}`);
    if (dark) await each.screenshot({ path: join(build, `dark-${name}.png`) });
  }
  await choose(each, 2);
  await goTo('profile', each);
  await new Promise((done) => setTimeout(done, 500));
  await noViolations(each, `broken file, ${dark ? 'dark' : 'light'}`);
  await each.keyboard.press('?');
  await noViolations(each, `help, ${dark ? 'dark' : 'light'}`);
  await each.screenshot({ path: join(build, `help-${dark ? 'dark' : 'light'}.png`) });
  await each.close();
}
await quiet(undefined, 'light and dark');
noteStep('axe finds no violation, light and dark');

for (const width of [360, 768, 1280, 2560]) {
  const each = await openPage({ width, height: width < 500 ? 740 : width > 2000 ? 1300 : 900 });
  const empty = await each.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(empty <= width, `empty page: ${empty} px at ${width}`);
  await drop(each, [good[0], good[13] ?? good[1], broken[0]]);
  await allRead(each, 3);
  await refined(each);
  for (const name of ['profile', 'stage', 'compare', 'export', 'units', 'colour']) {
    await goTo(name, each);
    await new Promise((done) => setTimeout(done, 1200));
    const wide = await each.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${name}: ${wide} px at ${width}`);
    if (name === 'profile' || name === 'stage' || width === 360) await each.screenshot({ path: join(build, `width-${width}-${name}.png`), fullPage: width < 800 });
  }
  await each.close();
}
await quiet(undefined, 'widths');
noteStep('no horizontal scrolling from 360 to 2560');

// ---- in a sandboxed frame, as a report has it

{
  const frame = join(build, 'made/frame.html');
  const text = readFileSync(join(build, 'gonio.html'), 'utf8').replace(/[&"]/g, (c) => ({ '&': '&amp;', '"': '&quot;' })[c]);
  writeFileSync(frame, `<!DOCTYPE html><title>frame</title><iframe title="gonio" sandbox="allow-scripts" style="width:1200px;height:800px" srcdoc="${text}"></iframe>
<script>addEventListener('message', (event) => { if (event.data.type === 'gonio-ready') event.source.postMessage({ type: 'gonio-open', files: [{ name: 'lamp.ies', bytes: ${JSON.stringify(whole.toString('latin1'))} }], rig: { schema: 'gonio.rig/1', stage: 'floor', lights: [{ shape: 'ies:lamp.ies,opening', position: [0, 0, 2.6] }] } }, '*'); });</script>`);
  const outer = await browser.newPage();
  outer.on('console', (message) => ['error', 'warn'].includes(message.type()) && noise.push(message.text()));
  await outer.goto(pathToFileURL(frame).href);
  const inner = await outer.waitForFrame((each) => each !== outer.mainFrame() && each.url().startsWith('about:srcdoc'));
  await inner.waitForFunction(() => document.querySelector('.stage')?.dataset.quality === 'refined', { timeout: 90000 });
  assert.equal(await inner.evaluate(() => document.querySelector('.file .name').textContent), 'lamp.ies');
  await outer.close();
  await quiet(undefined, 'a sandboxed frame');
  noteStep('works in a sandboxed frame');
}

await browser.close();

// Without SIMD the page says what it needs.
{
  const old = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true, args: ['--no-sandbox', '--js-flags=--no-enable-ssse3'] });
  const each = await old.newPage();
  await each.goto(page);
  await each.waitForFunction(() => !document.getElementById('notice').hidden, { timeout: 60000 });
  assert.equal(await each.evaluate(() => document.getElementById('notice').textContent), 'gonio needs WebAssembly with SIMD, which this browser does not have: Chromium 95, Firefox 113, Safari 16.4 or later have it.');
  await each.screenshot({ path: join(build, 'no-simd.png') });
  await old.close();
  noteStep('without SIMD the page says what it needs');
}
writeFileSync(join(build, 'figures.json'), `${JSON.stringify(figures, null, 2)}\n`);
console.log(JSON.stringify(figures));
