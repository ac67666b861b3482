// What the page holds: the profiles, the rig that is shown with how it is shown, and what the reader prefers. Others change
// it through these functions and hear of it by events: 'files', 'file', 'select', 'doc', 'tab', 'prefs', 'history'.
import { byId, textOf } from './dom.mjs';
import { Engine, reportOf, Cancelled, succeeded } from './engine.mjs';
import { placed, stageOf, withRigDefaults } from './stages.mjs';

const target = new EventTarget();
export const on = (names, call) => names.split(' ').forEach((name) => target.addEventListener(name, (event) => call(event.detail)));
export const emit = (name, detail) => target.dispatchEvent(new CustomEvent(name, { detail }));

// A screen reader says it, the status line shows it.
export function say(text) {
  byId('live').textContent = text;
}

export function notice(content) {
  const box = byId('notice');
  box.hidden = !content;
  box.replaceChildren(...(content ? [content] : []));
}

// ---- preferences: remembered where the browser allows it (not in the frame of a report)

const kept = { length: 'm', illuminance: 'lx', digits: 'exact', theme: 'auto', keys: 'on', flux: 'lm' };
try {
  const stored = JSON.parse(localStorage.getItem('gonio') ?? '{}');
  for (const key of Object.keys(kept)) if (typeof stored[key] === 'string') kept[key] = stored[key];
} catch { /* no storage here */ }
export const prefs = kept;

export function prefer(key, value) {
  prefs[key] = value;
  try {
    localStorage.setItem('gonio', JSON.stringify(prefs));
  } catch { /* no storage here */ }
  emit('prefs', key);
}

// ---- the workers

function showWork() {
  const active = [commands, ...watched].filter((engine) => engine.busy && engine.label);
  const labels = [...new Set(active.map((engine) => engine.label))];
  clearTimeout(showWork.timer);
  // Only what takes long is worth a word.
  const show = () => {
    byId('work').textContent = labels.length ? `Working: ${labels.join(', ')}…` : '';
    byId('cancel').hidden = labels.length === 0;
  };
  if (labels.length) showWork.timer = setTimeout(show, 300);
  else show();
}
const watched = [];
export const watch = (engine) => watched.push(engine);
export const newEngine = () => new Engine(showWork);
export const commands = newEngine(); // everything but pictures

export function cancelAll() {
  const working = [commands, ...watched].filter((engine) => engine.busy);
  for (const engine of working) engine.cancel();
  if (working.length) say('Cancelled');
}

// ---- profiles

export const files = [];
let selectedId;
let fileNumber = 0;
export const selected = () => files.find((file) => file.id === selectedId);
export const fileById = (id) => files.find((file) => file.id === id);

// Names go to the tool as words and into rigs, where commas, dashes and slashes mean something.
function safeName(name) {
  const dot = name.lastIndexOf('.');
  const clean = (text) => text.normalize('NFKD').replace(/[^A-Za-z0-9_-]+/g, '_').replace(/^[-_]+|_+$/g, '').slice(0, 60);
  const stem = clean(dot > 0 ? name.slice(0, dot) : name) || 'profile';
  const extension = dot > 0 ? clean(name.slice(dot + 1)).toLowerCase().slice(0, 8) : '';
  for (let i = 1; ; ++i) {
    const path = `${stem}${i > 1 ? `-${i}` : ''}${extension ? `.${extension}` : ''}`;
    if (!files.some((file) => file.path === path)) return path;
  }
}

// The text as the tool reads it.
function decode(bytes) {
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return new TextDecoder('utf-16be').decode(bytes);
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return new TextDecoder('utf-16le').decode(bytes);
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

export const asBytes = (data) => (typeof data === 'string' ? new TextEncoder().encode(data)
  : data instanceof ArrayBuffer ? new Uint8Array(data) : new Uint8Array(data.buffer, data.byteOffset, data.byteLength));

// Who opens a saved state (link.mjs, which needs this module).
let openState = () => false;
export const setStateOpener = (open) => { openState = open; };

const looksLikeRig = (name, bytes) => /\.json$/i.test(name) && /gonio\.rig\//.test(textOf(bytes.subarray(0, 4096)));

// Adds {name, bytes}; the first new profile is selected and lit at once, the facts of all follow.
export function addFiles(list) {
  const added = [];
  let rig;
  for (const { name, bytes: data } of list) {
    const bytes = asBytes(data);
    if (/\.json$/i.test(name) && textOf(bytes.subarray(0, 64)).startsWith('{"gonio":1,')) {
      if (!openState(textOf(bytes))) notice(document.createTextNode(`${name} holds no state that can be opened.`));
      continue;
    }
    if (looksLikeRig(name, bytes)) {
      rig = textOf(bytes);
      continue;
    }
    const file = { id: ++fileNumber, name: String(name), path: safeName(String(name)), bytes, state: 'reading', added_ms: performance.now() };
    Object.defineProperty(file, 'text', { get() { return (this.decoded ??= decode(this.bytes)); } });
    files.push(file);
    added.push(file);
  }
  if (added.length) {
    emit('files');
    if (['units', 'colour'].includes(tabName)) showTab('profile');
    selectFile(added[0].id);
    // The first picture goes before: both need a processor.
    afterPicture().then(() => added.forEach(examine));
    say(`${added.length} ${added.length === 1 ? 'profile' : 'profiles'} added`);
  }
  if (rig) openRig(rig);
  return added;
}

export function removeFile(id) {
  const index = files.findIndex((file) => file.id === id);
  if (index < 0) return;
  const [gone] = files.splice(index, 1);
  emit('files');
  if (selectedId === id) selectFile(files[Math.min(index, files.length - 1)]?.id);
  say(`${gone.name} removed`);
}

export function selectFile(id) {
  selectedId = id;
  const file = selected();
  if (file && followsSelection()) doc.rig.lights[doc.active].shape = shapeOf(file);
  emit('select', file);
}

const afterPicture = () => new Promise((resolve) => {
  target.addEventListener('lit', resolve, { once: true });
  setTimeout(resolve, 150);
});

// What `info` and `check` say. A file that cannot be read has only the second.
async function examine(file) {
  const own = { [file.path]: file.bytes };
  try {
    const check = await commands.run(['check', '--json', file.path], own, { label: 'reading profiles' });
    file.check = reportOf(check);
    if (file.check.readable) {
      const answer = await commands.run(['info', '--json', '--all', file.path], own, { label: 'reading profiles' });
      file.infoText = textOf(answer.stdout);
      file.info = reportOf(answer);
    }
    file.state = file.check.readable ? 'read' : 'broken';
  } catch (error) {
    file.state = 'failed';
    file.error = error instanceof Cancelled ? Object.assign(new Error('reading was cancelled'), { code: '' }) : error;
  }
  emit('file', file);
}

export const retry = (file) => {
  file.state = 'reading';
  file.error = undefined;
  emit('file', file);
  return examine(file);
};

// ---- the document: the rig and how it is shown; this is what undo goes back over and a link keeps

const firstView = { mode: 'beauty', exposure: 'auto', view: 'Standard', shadows: 'soft', bounces: -1 };
export let doc = newDoc();

function newDoc() {
  return { rig: { schema: 'gonio.rig/1', lights: [{ shape: '' }], stage: 'room' }, active: 0, view: { ...firstView } };
}

export const shapeOf = (file) => `ies:${file.path},opening`;
export const activeLight = () => placed(doc.rig.lights[doc.active] ?? {}, doc.rig);
// A light that has a profile of the list shows the one that is selected.
function followsSelection() {
  const shape = doc.rig.lights[doc.active]?.shape;
  return shape === '' || /^ies:/.test(shape ?? '');
}

// The rig as text, with what defaults of the stage stand for, and the files that it names.
export function rigOf(document = doc) {
  const { camera, ...rig } = document.rig;
  const lights = rig.lights.map((light) => placed(light, rig));
  return { ...rig, lights, ...(camera ? { camera } : {}) };
}

export function filesOf(rig) {
  const named = {};
  for (const light of rig.lights)
    for (const file of files)
      if (String(light.shape).split(/[:,=]/).includes(file.path)) named[file.path] = file.bytes;
  return named;
}

export function cameraOf(document = doc) {
  const stage = stageOf(document.rig).camera;
  const own = document.rig.camera ?? {};
  return { position: own.position ?? stage.position, target: own.target ?? stage.target, fov: own.fov ? parseFloat(own.fov) : undefined, stageFov: stage.fov };
}

const past = [];
const future = [];
let last = { key: '', time: 0 };
export const canUndo = () => past.length > 0;
export const canRedo = () => future.length > 0;

// Changes the document. Changes of one `key` that follow one another closely, as in a drag, are one step to undo.
export function change(key, edit) {
  const now = performance.now();
  if (key !== last.key || now - last.time > 1000 || past.length === 0) past.push(JSON.stringify(doc));
  if (past.length > 200) past.shift();
  last = { key, time: now };
  future.length = 0;
  edit(doc);
  emit('doc', key);
  emit('history');
}

function travel(from, to, word) {
  if (from.length === 0) return;
  to.push(JSON.stringify(doc));
  doc = JSON.parse(from.pop());
  last = { key: '', time: 0 };
  // A file that was removed meanwhile is replaced by the one selected.
  const file = selected();
  const shape = doc.rig.lights[doc.active]?.shape ?? '';
  if (file && /^ies:/.test(shape) && !files.some((each) => shape.includes(each.path))) doc.rig.lights[doc.active].shape = shapeOf(file);
  emit('doc', 'history');
  emit('history');
  say(word);
}
export const undo = () => travel(past, future, 'Undone');
export const redo = () => travel(future, past, 'Redone');

const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

// A document from outside: only its shape is looked at here; the tool judges the values.
export function setDoc(given) {
  const rig = isObject(given?.rig) ? given.rig : undefined;
  if (!rig || !Array.isArray(rig.lights) || rig.lights.length === 0 || !rig.lights.every(isObject)) return false;
  const view = isObject(given.view) ? given.view : {};
  change('open', (document) => {
    document.rig = { schema: 'gonio.rig/1', ...rig };
    document.active = Number.isInteger(given.active) && given.active >= 0 && given.active < rig.lights.length ? given.active : 0;
    document.view = { ...firstView };
    if (['beauty', 'falsecolour', 'isolux'].includes(view.mode)) document.view.mode = view.mode;
    if (view.exposure === 'auto' || Number.isFinite(view.exposure)) document.view.exposure = view.exposure;
    if (['Standard', 'Filmic'].includes(view.view)) document.view.view = view.view;
    if (['off', 'hard', 'soft'].includes(view.shadows)) document.view.shadows = view.shadows;
    if (Number.isInteger(view.bounces) && view.bounces >= -1 && view.bounces <= 64) document.view.bounces = view.bounces;
  });
  return true;
}

const greatestRig = 20000; // lights

const lightsOf = (rig) => (Array.isArray(rig?.lights) ? rig.lights.filter(isObject) : []);
const standsForSeveral = (light) => ['lights', 'array', 'positions', 'luminaire'].some((key) => key in light);

// Files are known here by safe names, also those of luminaires and in groups.
function useSafeNames(light) {
  lightsOf(light).forEach(useSafeNames);
  const match = /^ies:([^,]*)(.*)$/.exec(typeof light.shape === 'string' ? light.shape : '');
  const base = match?.[1].split('/').pop();
  const file = match && files.find((each) => each.name === base || each.name === match[1] || each.path === base);
  if (file) light.shape = `ies:${file.path}${match[2]}`;
}

// The same rig with each light of its arrays, groups and luminaires written out, by the tool.
async function expanded(rig) {
  const inputs = Object.fromEntries(files.map((file) => [file.path, file.bytes]));
  const answer = succeeded(await commands.run(['rig', 'expand', 'rig.json'], { ...inputs, 'rig.json': JSON.stringify(rig) }, { label: 'reading the rig' }));
  return JSON.parse(textOf(answer.stdout));
}

// A rig file, comments included. Resolves to whether it was opened.
export async function openRig(text) {
  const refuse = (words) => {
    notice(document.createTextNode(words));
    return false;
  };
  let rig;
  try {
    rig = JSON.parse(text.replace(/("(?:\\.|[^"\\])*")|\/\/[^\n]*|\/\*[\s\S]*?\*\//g, (_, string) => string ?? ''));
  } catch (error) {
    return refuse(`The rig is not JSON: ${error.message}`);
  }
  lightsOf(rig).forEach(useSafeNames);
  if (isObject(rig?.luminaires)) Object.values(rig.luminaires).filter(isObject).forEach(useSafeNames);
  if (lightsOf(rig).some(standsForSeveral)) {
    try {
      rig = await expanded(rig);
    } catch (error) {
      return refuse(`The rig cannot be opened: ${error.message}${error.hint ? ` (${error.hint})` : ''}`);
    }
  }
  if (lightsOf(rig).length > greatestRig)
    return refuse(`The rig has ${rig.lights.length} lights, and the page takes ${greatestRig}: gonio preview draws them all.`);
  if (setDoc({ rig: { ...rig, lights: lightsOf(rig).map(withRigDefaults) } })) return true;
  return refuse('The rig has no lights: a rig is JSON with "schema": "gonio.rig/1" and "lights": […]');
}

let tabName = 'profile';
export const currentTab = () => tabName;
export function showTab(name) {
  tabName = name;
  emit('tab', name);
}
