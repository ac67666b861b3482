// The page's start: its views, keys and the ways in which others hand it files.
import { byId, card, el, fill } from './dom.mjs';
import {
  addFiles, asBytes, canRedo, canUndo, cancelAll, commands, currentTab, files, on, openRig, prefer, prefs, redo, say,
  selected, setStateOpener, showTab, undo,
} from './app.mjs';
import { examples, openPicker, startFileList, step } from './file_list.mjs';
import { factsCard } from './facts.mjs';
import { findingsCard } from './findings.mjs';
import { keywordsCard } from './keywords.mjs';
import { diagramCard } from './diagrams.mjs';
import { stageView } from './stage_view.mjs';
import { stagePanel } from './stage_panel.mjs';
import { compareView } from './compare_view.mjs';
import { exportView } from './export_view.mjs';
import { unitsView } from './units_view.mjs';
import { colourView } from './colour_view.mjs';
import { openFragment, openStateFile } from './link.mjs';
import { missingFeature } from './engine.mjs';

const tabs = [
  ['profile', 'Profile'], ['stage', 'Stage'], ['compare', 'Compare'], ['export', 'Export'], ['units', 'Units'], ['colour', 'Colour'],
];

function emptyState() {
  const open = (names) => addFiles(examples().filter(({ name }) => names.includes(name)).map(({ name, text }) => ({ name, bytes: text })));
  return el('div', { class: 'empty' },
    el('h2', {}, 'See what a light does'),
    el('p', {}, 'Drop photometric profiles here: IES, EULUMDAT or TM-33 files. They are measured, checked, drawn and lit on this machine; nothing is sent anywhere.'),
    el('div', { class: 'row centre' },
      el('button', { type: 'button', class: 'primary', onclick: openPicker }, 'Open profiles…'),
      el('button', { type: 'button', onclick: () => open(['downlight.ies', 'street.ldt']) }, 'Try two examples')),
    el('p', { class: 'muted' }, 'You can also paste the text of a file, or drop a rig (a JSON file of gonio.rig/1). Press ? for all keys.'));
}

function profileView(stage) {
  const [facts, findings, keywords, diagram] = [factsCard(), findingsCard(), keywordsCard(), diagramCard()];
  const stageSlot = el('div', { class: 'stage-slot' });
  const lit = card('On a stage', stageSlot);
  lit.classList.add('lit-card');
  lit.head.append(el('button', { type: 'button', class: 'small', onclick: () => showTab('stage') }, 'All controls'));
  const grid = el('div', { class: 'profile-grid' },
    el('div', { class: 'column' }, lit, findings), el('div', { class: 'column' }, diagram, keywords), el('div', { class: 'column' }, facts));
  const title = el('h2', { class: 'file-title' });
  const view = el('div', {}, title, grid);
  const show = (file) => {
    title.textContent = file?.name ?? '';
    document.title = file ? `${file.name}: gonio` : 'gonio: photometric lights';
    if (!file) return;
    for (const each of [facts, findings, keywords, diagram]) each.show(file);
  };
  on('select', show);
  on('file', (file) => file === selected() && show(file));
  on('tab', (name) => name === 'profile' && stageSlot.append(stage));
  stageSlot.append(stage);
  view.diagram = diagram;
  return view;
}

function buildPanels() {
  const stage = stageView();
  const bigSlot = el('div', { class: 'stage-slot big' });
  const views = {
    profile: profileView(stage),
    stage: el('div', { class: 'stage-grid' }, el('section', { class: 'card', 'aria-label': 'Lit stage' }, bigSlot), stagePanel(stage)),
    compare: compareView(), export: exportView(), units: unitsView(), colour: colourView(),
  };
  on('tab', (name) => name === 'stage' && bigSlot.append(stage));
  const empty = emptyState();
  const panels = {};
  for (const [name, label] of tabs) {
    panels[name] = el('div', { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}`, tabindex: -1, hidden: true }, views[name]);
    byId('tabs').append(el('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onclick: () => showTab(name) }, label));
  }
  byId('panels').append(...Object.values(panels));
  byId('tabs').addEventListener('keydown', (event) => {
    const names = tabs.map(([name]) => name);
    const index = names.indexOf(currentTab());
    const next = { ArrowRight: names[(index + 1) % names.length], ArrowLeft: names[(index + names.length - 1) % names.length], Home: names[0], End: names.at(-1) }[event.key];
    if (!next) return;
    showTab(next);
    byId(`tab-${next}`).focus();
    event.preventDefault();
  });
  // Units and colours need no profile.
  const needsProfile = (name) => ['profile', 'stage', 'compare', 'export'].includes(name);
  function arrange() {
    const name = panels[currentTab()] ? currentTab() : 'profile';
    for (const [each] of tabs) {
      const tab = byId(`tab-${each}`);
      tab.setAttribute('aria-selected', each === name);
      tab.tabIndex = each === name ? 0 : -1;
      panels[each].hidden = each !== name;
    }
    const nothing = files.length === 0 && needsProfile(name);
    for (const each of panels[name].children) each.hidden = nothing && each !== empty;
    if (nothing) panels[name].append(empty);
    else {
      empty.remove();
      for (const each of panels[name].children) each.hidden = false;
    }
    document.body.dataset.tab = name;
  }
  on('tab files', arrange);
  arrange();
  return { stage, views };
}

// ---- help

const keyList = [
  ['?', 'This list'], ['A', 'Add profiles'], ['1 … 6', 'Views'], ['J, K', 'Next profile, the one before'], ['Delete', 'Remove the profile (in the list)'],
  ['Ctrl Z, Ctrl Shift Z', 'Undo, redo changes of the stage'], ['Escape', 'Cancel what is being computed'],
  ['Arrow keys', 'On the stage: the camera goes around. On the solid: turn it'], ['+ and −', 'Nearer, farther'],
  ['Shift + arrow keys', 'Move the light; Page Up and Page Down lift and lower it'], ['Ctrl + arrow keys', 'Turn the light'],
  ['O, M, T, L', 'On the stage: dragging and arrow keys orbit, move, turn, measure lux'], ['R', 'On the stage: camera and light as at first'],
];

function helpDialog() {
  const single = el('input', { type: 'checkbox', checked: prefs.keys === 'on', onchange: () => prefer('keys', single.checked ? 'on' : 'off') });
  const dialog = el('dialog', { class: 'help', 'aria-labelledby': 'help-title' },
    el('h2', { id: 'help-title' }, 'Keys'),
    el('dl', { class: 'keys' }, ...keyList.flatMap(([keys, what]) => [el('dt', {}, el('kbd', {}, keys)), el('dd', {}, what)])),
    el('label', { class: 'check' }, single, ' keys without Ctrl work'),
    el('p', { class: 'muted' }, 'Everything is computed on this machine by gonio, as WebAssembly. The page cannot send anything: its policy forbids connections.'),
    el('form', { method: 'dialog' }, el('button', { class: 'primary' }, 'Close')));
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
  document.body.append(dialog);
  return dialog;
}

function startKeys(help) {
  addEventListener('keydown', (event) => {
    const typing = event.target instanceof HTMLElement && event.target.matches('input:not([type=checkbox], [type=range]), textarea, select');
    const command = event.ctrlKey || event.metaKey;
    if (help.open) return;
    if (event.key === 'Escape') {
      cancelAll();
      return;
    }
    if (command && !typing && /^[zy]$/i.test(event.key)) {
      if (event.key.toLowerCase() === 'y' || event.shiftKey) redo();
      else undo();
      event.preventDefault();
      return;
    }
    if (typing || command || event.altKey || prefs.keys === 'off') return;
    const tab = tabs[Number(event.key) - 1];
    if (event.key === '?') help.showModal();
    else if (tab) {
      showTab(tab[0]);
      byId(`tab-${tab[0]}`).focus({ preventScroll: true });
    } else if (event.key === 'a') openPicker();
    else if (event.key === 'j') step(1);
    else if (event.key === 'k') step(-1);
    else return;
    event.preventDefault();
  });
}

// ---- light and dark

function startTheme() {
  const names = { auto: 'as the system', light: 'light', dark: 'dark' };
  const system = matchMedia('(prefers-color-scheme: dark)');
  const apply = () => {
    const chosen = prefs.theme in names && prefs.theme !== 'auto';
    document.documentElement.dataset.theme = chosen ? prefs.theme : system.matches ? 'dark' : 'light';
    byId('theme').setAttribute('aria-label', `Colours of the page: ${names[prefs.theme] ?? names.auto}`);
  };
  byId('theme').addEventListener('click', () => {
    prefer('theme', { auto: 'light', light: 'dark', dark: 'auto' }[prefs.theme] ?? 'auto');
    say(`Colours of the page: ${names[prefs.theme]}`);
  });
  on('prefs', (key) => key === 'theme' && apply());
  system.addEventListener('change', apply);
  apply();
}

// A report or another page hands over files: {type: 'gonio-open', files: [{name, bytes}], rig}. Only the parent may.
function startMessages() {
  if (window.parent === window) return;
  addEventListener('message', (event) => {
    if (event.source !== window.parent || event.data?.type !== 'gonio-open') return;
    const given = Array.isArray(event.data.files) ? event.data.files : [];
    const taken = given.filter((file) => typeof file?.name === 'string'
      && (typeof file.bytes === 'string' || file.bytes instanceof ArrayBuffer || ArrayBuffer.isView(file.bytes)));
    if (taken.length) addFiles(taken.map(({ name, bytes }) => ({ name, bytes: asBytes(bytes) })));
    if (event.data.rig) openRig(typeof event.data.rig === 'string' ? event.data.rig : JSON.stringify(event.data.rig));
    if (typeof event.data.tab === 'string') showTab(event.data.tab);
  });
  window.parent.postMessage({ type: 'gonio-ready' }, '*');
}

async function start() {
  startTheme();
  setStateOpener(openStateFile);
  const { stage } = buildPanels();
  startFileList();
  startKeys(helpDialogOpener());
  byId('undo').addEventListener('click', undo);
  byId('redo').addEventListener('click', redo);
  byId('cancel').addEventListener('click', cancelAll);
  on('history doc', () => {
    byId('undo').disabled = !canUndo();
    byId('redo').disabled = !canRedo();
  });
  addEventListener('hashchange', openFragment);
  try {
    await commands.start();
    document.body.dataset.ready = performance.now().toFixed(1);
    await openFragment();
    startMessages();
    await stage.warm(examples().map(({ name, text }) => ({ name, bytes: asBytes(text) })));
    document.body.dataset.warm = performance.now().toFixed(1);
  } catch (error) {
    const missing = missingFeature();
    fill(byId('notice'), el('p', {}, missing ? `gonio needs ${missing}, which this browser does not have: Chromium 95, Firefox 113, Safari 16.4 or later have it.`
      : `gonio does not run in this browser: ${error.message}`));
    byId('notice').hidden = false;
  }
}

function helpDialogOpener() {
  const dialog = helpDialog();
  byId('help').addEventListener('click', () => dialog.showModal());
  return dialog;
}

start();
