// The list of profiles, and the ways in which they come: dropped, picked, pasted, the examples.
import { byId, el, fill } from './dom.mjs';
import { addFiles, emit, files, notice, on, removeFile, say, selectFile, selected } from './app.mjs';
import { briefNumber } from './numbers.mjs';

const greatestFile = 64 * 1024 * 1024;

export const examples = () => JSON.parse(byId('examples').textContent);

async function addPicked(list) {
  const read = [];
  const refused = [];
  for (const file of list) {
    if (file.size > greatestFile) {
      refused.push(file.name);
      continue;
    }
    try {
      read.push({ name: file.name, bytes: await file.arrayBuffer() });
    } catch {
      refused.push(file.name); // a folder, or gone since
    }
  }
  notice(refused.length ? document.createTextNode(`Not opened: ${refused.join(', ')} (a folder, too large or not readable)`) : undefined);
  if (read.length) addFiles(read);
}

export function openPicker() {
  byId('picker').click();
}

function badge(file) {
  if (file.state === 'reading') return el('span', { class: 'badge', title: 'being read' }, '…');
  if (file.state !== 'read') return el('span', { class: 'badge error' }, 'unreadable');
  const { errors, warnings } = file.check;
  if (errors) return el('span', { class: 'badge error' }, `${errors} ${errors === 1 ? 'error' : 'errors'}`);
  if (warnings) return el('span', { class: 'badge warning' }, `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}`);
  return null;
}

function summary(file) {
  if (file.state === 'reading') return 'reading…';
  if (file.info) return `${briefNumber(file.info.flux_lm)} lm · ${briefNumber(file.info.peak_cd)} cd`;
  return file.check?.diagnostics.findLast((entry) => entry.severity === 'error')?.message ?? file.error?.message ?? '';
}

// Drawn anew: the focus and what is in sight stay.
function draw() {
  const chosen = selected();
  const focused = byId('files').contains(document.activeElement) ? document.activeElement.dataset.id : undefined;
  byId('count').textContent = files.length ? String(files.length) : '';
  fill(byId('files'), ...files.map((file) => el('li', { class: file === chosen ? 'file chosen' : 'file' },
    el('button', {
      type: 'button', class: 'file-name', 'aria-current': file === chosen ? 'true' : undefined, 'data-id': file.id,
      onclick: () => selectFile(file.id),
    }, el('span', { class: 'name' }, file.name), el('span', { class: 'facts' }, summary(file)), badge(file)),
    el('button', { type: 'button', class: 'icon remove', 'aria-label': `Remove ${file.name}`, title: 'Remove (Delete)', onclick: () => removeFile(file.id) }, '×'))));
  if (focused) byId('files').querySelector(`[data-id="${focused}"]`)?.focus();
}

function drawSoon() {
  drawSoon.asked ??= requestAnimationFrame(() => {
    drawSoon.asked = undefined;
    draw();
  });
}

function drawChosen() {
  draw();
  byId('files').querySelector('.chosen')?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
}

// A drag that passes over the page's elements enters and leaves each of them.
function acceptDrops() {
  let depth = 0;
  const zone = byId('dropzone');
  const holdsFiles = (event) => event.dataTransfer?.types.includes('Files');
  addEventListener('dragenter', (event) => {
    if (!holdsFiles(event)) return;
    ++depth;
    zone.hidden = false;
    event.preventDefault();
  });
  addEventListener('dragover', (event) => holdsFiles(event) && event.preventDefault());
  addEventListener('dragleave', (event) => {
    if (holdsFiles(event) && --depth <= 0) zone.hidden = true;
  });
  addEventListener('drop', (event) => {
    depth = 0;
    zone.hidden = true;
    if (!event.dataTransfer) return;
    event.preventDefault();
    addPicked([...event.dataTransfer.files]);
  });
}

// A pasted file, or the text of one: IESNA and TILT= show an IES file, a tag TM-33, else EULUMDAT. The tool judges it.
function acceptPaste() {
  addEventListener('paste', (event) => {
    if (event.target instanceof HTMLElement && event.target.matches('input, textarea')) return;
    const pasted = [...(event.clipboardData?.files ?? [])];
    if (pasted.length) {
      event.preventDefault();
      addPicked(pasted);
      return;
    }
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (text.trim().length === 0) return;
    event.preventDefault();
    const name = /gonio\.rig\//.test(text) ? 'pasted.json' : /^\s*(IESNA|\[)|TILT=/.test(text) ? 'pasted.ies' : /^\s*</.test(text) ? 'pasted.xml' : 'pasted.ldt';
    addFiles([{ name, bytes: text }]);
  });
}

export function startFileList() {
  on('files', draw);
  on('file', drawSoon);
  on('select', drawChosen);
  byId('open').addEventListener('click', openPicker);
  byId('picker').addEventListener('change', (event) => {
    addPicked([...event.target.files]).then(() => { event.target.value = ''; });
  });
  byId('files').addEventListener('keydown', (event) => {
    const buttons = [...byId('files').querySelectorAll('.file-name')];
    const index = buttons.indexOf(event.target);
    if (index < 0) return;
    if (event.key === 'Delete') {
      removeFile(files[index].id);
      byId('files').querySelectorAll('.file-name')[Math.min(index, files.length - 1)]?.focus();
    } else if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      step(event.key === 'ArrowDown' ? 1 : -1);
      byId('files').querySelector('[aria-current]')?.focus();
    } else return;
    event.preventDefault();
  });
  acceptDrops();
  acceptPaste();
  draw();
}

// Selects the next or the one before.
export function step(by) {
  const index = files.indexOf(selected());
  const next = files[Math.min(files.length - 1, Math.max(0, index + by))];
  if (next && next !== selected()) {
    selectFile(next.id);
    say(next.name);
  }
  emit('stepped');
}
