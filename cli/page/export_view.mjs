// What `convert`, `bake` and `import` write, as files or one zip; the rig, and the state as a link or a file.
import { card, download, el, field, fill, problem, select } from './dom.mjs';
import { commands, currentTab, files, filesOf, on, rigOf, say, selected } from './app.mjs';
import { Cancelled, diagnosticsOf, reportOf, succeeded } from './engine.mjs';
import { zipOf } from './zip.mjs';
import { examples } from './file_list.mjs';
import { greatestLink, linkOf, stateFile } from './link.mjs';

const baseName = (path) => path.split('/').pop();
const stemOf = (file) => file.path.replace(/\.[^.]*$/, '');

// One file as it is, more of them as a zip.
function give(written, name) {
  const paths = Object.keys(written);
  if (paths.length === 0) throw new Error('nothing was written');
  if (paths.length === 1) download(baseName(paths[0]), written[paths[0]]);
  else download(`${name}.zip`, zipOf(written), 'application/zip');
  return paths;
}

export function exportView() {
  const all = el('input', { type: 'checkbox' });
  const subject = el('p', { class: 'pad' });

  // A card with a form and what came of it.
  function job(title, fields, label, perform) {
    const outcome = el('div', { class: 'outcome', 'aria-live': 'polite' });
    const button = el('button', { type: 'submit', class: 'primary' }, label);
    const form = el('form', { class: 'form pad', onsubmit: async (event) => {
      event.preventDefault();
      button.disabled = true;
      fill(outcome, el('p', { class: 'muted' }, 'Working…'));
      try {
        const { paths, stderr = '' } = await perform();
        const said = diagnosticsOf(stderr);
        fill(outcome, el('p', { class: 'ok' }, `Saved: ${paths.length > 6 ? `${paths.slice(0, 5).join(', ')} and ${paths.length - 5} more` : paths.join(', ')}`), said.length ? problem({ diagnostics: said }) : null);
        say(`${title}: ${paths.length} ${paths.length === 1 ? 'file' : 'files'} saved`);
      } catch (error) {
        fill(outcome, error instanceof Cancelled ? el('p', {}, 'Cancelled.') : problem(error));
      }
      button.disabled = false;
    } }, ...fields, el('div', {}, button));
    return card(title, form, outcome);
  }

  const chosen = () => (all.checked ? files.filter((file) => file.info) : [selected()].filter((file) => file?.info));
  const bytesOf = (list) => Object.fromEntries(list.map((file) => [file.path, file.bytes]));
  function needed() {
    const list = chosen();
    if (list.length === 0) throw new Error('open a profile that can be read first');
    return list;
  }

  // ---- convert
  const format = select('Format', [['ies', 'IES (LM-63)'], ['ldt', 'EULUMDAT'], ['tm33', 'TM-33 (XML)']], 'ies', () => { dialectField.hidden = format.value !== 'ies'; });
  const dialect = select('Dialect', [['', 'as the source, else LM-63-2002'], ['lm-63-1995', 'LM-63-1995'], ['lm-63-2002', 'LM-63-2002'], ['lm-63-2019', 'LM-63-2019'], ['portable', 'portable: read the same way everywhere']], '', () => {});
  const dialectField = field('Dialect', dialect);
  const convert = job('Another format', [field('Format', format), dialectField], 'Convert', async () => {
    const written = {};
    let stderr = '';
    for (const file of needed()) {
      const extension = { ies: 'ies', ldt: 'ldt', tm33: 'xml' }[format.value];
      const output = `${stemOf(file)}.${extension}`;
      const answer = succeeded(await commands.run(['convert', file.path, '--to', format.value, '-o', '-', ...(format.value === 'ies' && dialect.value ? ['--dialect', dialect.value] : [])], bytesOf([file]), { label: 'converting' }));
      written[output] = answer.stdout;
      stderr += answer.stderr;
    }
    return { paths: give(written, 'converted'), stderr };
  });

  // ---- bake
  const engine = select('Engine', [['', 'a layout of my own']], '', () => { layoutFields.hidden = engine.value !== ''; });
  const layout = select('Layout', [['latlong', 'latlong']], 'latlong', () => {});
  const size = el('input', { type: 'text', value: '512x256', spellcheck: 'false' });
  const normalize = select('A texel of 1 means', [['peak', 'the peak'], ['none', 'one candela'], ['mean', 'the mean'], ['flux', 'the flux']], 'peak', () => {});
  const picture = select('File', [['png', 'PNG']], 'png', () => {});
  const layoutFields = el('div', { class: 'form' }, field('Layout', layout), field('Size', size), field('A texel of 1 means', normalize), field('File', picture));
  const bake = job('Texture', [field('Engine', engine), layoutFields], 'Bake', async () => {
    const written = {};
    let stderr = '';
    for (const file of needed()) {
      const words = engine.value ? ['--engine', engine.value] : ['--layout', layout.value, '-s', size.value.trim(), '--normalize', normalize.value];
      const output = `${stemOf(file)}.${engine.value ? await extensionOf(file, engine.value) : picture.value}`;
      const answer = succeeded(await commands.run(['bake', file.path, ...words, '-o', output], bytesOf([file]), { label: 'baking', patience: 60000 }));
      Object.assign(written, answer.files);
      stderr += answer.stderr;
    }
    return { paths: give(written, engine.value ? `texture-${engine.value}` : 'texture'), stderr };
  });

  // Which picture format an engine's texture needs: the first that can be written.
  const extensions = new Map();
  async function extensionOf(file, name) {
    if (extensions.has(name)) return extensions.get(name);
    const formats = [...picture.options].map((option) => option.value);
    for (const extension of formats) {
      const answer = await commands.run(['bake', file.path, '--engine', name, '-o', `x.${extension}`], bytesOf([file]));
      if (answer.status === 0) {
        extensions.set(name, extension);
        return extension;
      }
    }
    return formats[0];
  }

  // ---- import
  const targets = el('fieldset', { class: 'targets' }, el('legend', {}, 'Programs'));
  const whole = select('What', [['profile', 'the profile'], ['rig', 'the rig of the Stage view']], 'profile', () => {});
  const assets = job('For engines and renderers', [field('What', whole), targets], 'Make the files', async () => {
    const picked = [...targets.querySelectorAll('input:checked')].map((input) => input.value);
    if (picked.length === 0) throw new Error('choose a program');
    const rig = rigOf();
    const inputs = whole.value === 'rig' ? { 'scene.rig.json': JSON.stringify(rig, null, 2), ...filesOf(rig) } : bytesOf(needed());
    const names = whole.value === 'rig' ? ['scene.rig.json'] : needed().map((file) => file.path);
    // The folder must be there.
    const answer = succeeded(await commands.run(['import', ...names, '--to', picked.join(','), '-O', 'assets'], { ...inputs, 'assets/.folder': '' }, { label: 'making the files', patience: 60000 }));
    return { paths: give(answer.files, `assets-${picked.length === 1 ? picked[0] : 'for-programs'}`), stderr: answer.stderr };
  });

  // ---- rig and state
  const rigOutcome = el('div', { class: 'outcome', 'aria-live': 'polite' });
  const attempt = (perform) => async () => {
    try {
      fill(rigOutcome, el('p', { class: 'ok' }, await perform()));
    } catch (error) {
      fill(rigOutcome, problem(error));
    }
  };
  const linkBox = el('input', { type: 'text', readonly: true, 'aria-label': 'Link to this state', class: 'wide', onfocus: (event) => event.target.select() });
  const state = card('Rig, link and state', el('div', { class: 'form pad' },
    el('div', { class: 'row' },
      el('button', { type: 'button', onclick: attempt(async () => {
        const rig = rigOf();
        const named = filesOf(rig);
        const text = `${JSON.stringify(rig, null, 2)}\n`;
        if (Object.keys(named).length === 0) download('scene.rig.json', text, 'application/json');
        else download('scene.zip', zipOf({ 'scene.rig.json': new TextEncoder().encode(text), ...named }), 'application/zip');
        return Object.keys(named).length ? 'Saved: scene.zip, with the rig and its profiles' : 'Saved: scene.rig.json';
      }) }, 'Save the rig'),
      el('button', { type: 'button', onclick: attempt(async () => {
        download('gonio-state.json', stateFile(), 'application/json');
        return 'Saved: gonio-state.json. Open it here to go on.';
      }) }, 'Save the state'),
      el('button', { type: 'button', onclick: attempt(async () => {
        const { link, left } = await linkOf();
        linkBox.value = link;
        linkBox.focus();
        const holds = left.length === 0 ? 'It holds the stage, the view and the profiles.'
          : `It holds the stage and the view, but not ${left.join(', ')}: a link has room for ${greatestLink} characters. To hand on the profile too, save the state and send that file.`;
        try {
          await navigator.clipboard.writeText(link);
          return `The link is copied. ${holds}`;
        } catch {
          return `The link is ready to be copied. ${holds}`;
        }
      }) }, 'Make a link')),
    linkBox), rigOutcome);

  const root = el('div', {}, el('div', { class: 'export-head' }, subject, el('label', { class: 'check pad' }, all, ' all profiles of the list')),
    el('div', { class: 'export-grid' }, el('div', { class: 'column' }, convert, assets), el('div', { class: 'column' }, bake, state)));

  let listed = false;
  async function list() {
    if (listed) return;
    listed = true;
    const entries = async (name) => reportOf(await commands.run(['list', name, '--json'])).entries;
    try {
      engine.setEntries([['', 'none: a layout of my own'], ...(await entries('engines')).map(({ name, summary }) => [name, summary])], '');
      layout.setEntries((await entries('layouts')).map(({ name, summary }) => [name, `${name}: ${summary}`]), 'latlong');
      // Formats that need OpenImageIO are listed, but not written here.
      const written = [];
      for (const { name, summary } of await entries('images')) {
        const answer = await commands.run(['bake', 'x.ies', '-s', '4x2', '--normalize', 'peak', '-o', `x.${name}`], { 'x.ies': examples()[0].text });
        if (answer.status === 0) written.push([name, summary]);
      }
      picture.setEntries(written.length ? written : [['png', 'PNG']], written.some(([name]) => name === 'png') ? 'png' : written[0]?.[0] ?? 'png');
      targets.append(...(await entries('targets')).map(({ name, summary }) => el('label', { class: 'check', title: summary }, el('input', { type: 'checkbox', value: name, checked: name === 'gltf' }), ` ${summary.split(':')[0].split(',')[0]}`)));
    } catch (error) {
      listed = false;
      fill(rigOutcome, problem(error));
    }
  }

  function refresh() {
    if (currentTab() !== 'export') return;
    list();
    const file = selected();
    fill(subject, file?.info ? 'Profile: ' : 'No profile that can be read is selected.', file?.info ? el('strong', {}, file.name) : null);
  }
  on('tab select file', refresh);
  return root;
}
