// The state in a link's fragment, or in a file: the document, the view, and small profiles. A fragment never leaves the
// machine on its own. What comes back is looked at as hostile.
import { addFiles, currentTab, doc, files, filesOf, notice, rigOf, selected, setDoc, showTab } from './app.mjs';

const greatestFragment = 200000; // characters that are read
export const greatestLink = 60000; // characters that are written: browsers, mail and messengers keep such a link whole
const greatestUnpacked = 8 * 1024 * 1024;

// A character for each byte: text of profiles is packed to a fifth of it.
function toLatin1(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return text;
}
const fromLatin1 = (text) => Uint8Array.from(text, (character) => character.charCodeAt(0));
const toBase64 = (bytes) => btoa(toLatin1(bytes));
const fromBase64 = (text) => fromLatin1(atob(text));
const urlSafe = (base64) => base64.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
const fromUrlSafe = (text) => fromBase64(text.replaceAll('-', '+').replaceAll('_', '/'));

const pack = async (text) => new Uint8Array(await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer());

// Stops when it grows beyond reason: a few bytes can announce gigabytes.
async function unpack(bytes) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > greatestUnpacked) {
      reader.cancel();
      throw new Error('the state is too large');
    }
    parts.push(value);
  }
  return new Blob(parts).text();
}

function stateOf(which) {
  const named = which === 'all' ? files : files.filter((file) => file.path in filesOf(rigOf()));
  return {
    gonio: 1, rig: doc.rig, active: doc.active, view: doc.view, tab: currentTab(), selected: selected()?.path,
    files: named.map((file) => ({ name: file.name, path: file.path, latin1: toLatin1(file.bytes) })),
  };
}

export const stateFile = () => JSON.stringify(stateOf('all'));

// {link, left}: `left` are the names of profiles that it has no room for.
export async function linkOf() {
  if (!/^(file|https?):$/.test(location.protocol)) throw new Error('a page inside a report has no link of its own: save the state instead');
  const link = async (state) => `${location.href.split('#')[0]}#s=${urlSafe(toBase64(await pack(JSON.stringify(state))))}`;
  const state = stateOf('rig');
  const whole = await link(state);
  if (whole.length <= greatestLink) return { link: whole, left: [] };
  return { link: await link({ ...state, files: [] }), left: state.files.map(({ name }) => name) };
}

// Applies a state; false where it is none.
function applyState(state) {
  if (state?.gonio !== 1) return false;
  const given = (Array.isArray(state.files) ? state.files : []).slice(0, 200)
    .filter((file) => typeof file?.name === 'string' && typeof (file.latin1 ?? file.base64) === 'string');
  const renamed = new Map();
  if (given.length) {
    const added = addFiles(given.map((file) => ({ name: file.name, bytes: file.latin1 === undefined ? fromBase64(file.base64) : fromLatin1(file.latin1) })));
    given.forEach((file, i) => added[i] && renamed.set(file.path, added[i].path));
  }
  const rig = JSON.parse(JSON.stringify(state.rig ?? {}));
  const missing = [];
  for (const light of Array.isArray(rig.lights) ? rig.lights : []) {
    const match = /^ies:([^,]*)(.*)$/.exec(light?.shape ?? '');
    if (!match) continue;
    const path = renamed.get(match[1]) ?? match[1];
    if (files.some((file) => file.path === path)) light.shape = `ies:${path}${match[2]}`;
    else {
      missing.push(path);
      light.shape = selected() ? `ies:${selected().path}${match[2]}` : '';
    }
  }
  if (!setDoc({ ...state, rig })) return false;
  if (typeof state.tab === 'string') showTab(state.tab);
  notice(missing.length ? document.createTextNode(`The link does not hold ${missing.join(', ')}: open the profile here.`) : undefined);
  return true;
}

// Text of a saved state.
export function openStateFile(text) {
  try {
    return applyState(JSON.parse(text));
  } catch {
    return false;
  }
}

// The fragment's state; true where there was one.
export async function openFragment() {
  const match = /^#s=([A-Za-z0-9_-]+)$/.exec(location.hash);
  if (!match) return false;
  try {
    if (match[1].length > greatestFragment) throw new Error('the link is too long');
    if (!applyState(JSON.parse(await unpack(fromUrlSafe(match[1]))))) throw new Error('it holds no state');
    return true;
  } catch (error) {
    notice(document.createTextNode(`The link cannot be opened: ${error.message}`));
    return false;
  }
}
