// The unit converter: `gonio units`, with what other programs make of the same number.
import { card, debounce, el, field, fill, problem, select } from './dom.mjs';
import { commands, currentTab, on } from './app.mjs';
import { Cancelled, errorOf, reportOf } from './engine.mjs';
import { exactNumber } from './numbers.mjs';

const unitNames = { lm: 'luminous flux', cd: 'luminous intensity', nt: 'luminance', ev: 'exposure value', lx: 'illuminance', fc: 'illuminance', fL: 'luminance', W: 'power' };

function programTable(list) {
  return el('table', { class: 'facts-table programs' }, el('caption', { class: 'hidden' }, 'What to type into other programs'),
    el('thead', {}, el('tr', {}, ...['Program', 'Light', 'Values'].map((text) => el('th', { scope: 'col' }, text)))),
    el('tbody', {}, ...list.map(({ program, has_light: has, light, fields, note }) => el('tr', {}, el('th', { scope: 'row' }, program),
      el('td', {}, has ? light : el('span', { class: 'muted' }, 'none')),
      el('td', {}, ...fields.map(({ name, value, unit }) => el('span', { class: 'value' }, `${name} `, el('strong', {}, value), unit ? ` ${unit}` : '')),
        note ? el('span', { class: 'muted value' }, note) : null)))));
}

export function unitsView() {
  const state = { value: '800lm', shape: 'sphere:r=3cm', to: '', policy: 'physical' };
  const result = el('div', { class: 'result', 'aria-live': 'polite' });
  const programs = el('div', { class: 'result' });
  const input = (label, key, properties) => {
    const control = el('input', { type: 'text', value: state[key], spellcheck: 'false', autocomplete: 'off', ...properties, oninput: debounce(200, () => {
      state[key] = control.value.trim();
      update();
    }) });
    return field(label, control);
  };
  const policy = select('Read as', [['physical', 'physical: lumens are the emitted flux']], 'physical', (value) => {
    state.policy = value;
    update();
  });
  const root = el('div', { class: 'tool-grid' },
    card('Convert', el('div', { class: 'form pad' },
      input('Amount', 'value', { placeholder: '800lm' }),
      input('Shape', 'shape', { placeholder: 'point' }),
      input('Units of the result', 'to', { placeholder: 'all that apply; or lx@2m,fc@6ft,nt' }),
      field('Read as', policy)), result),
    card('In other programs', el('p', { class: 'pad muted' }, 'What to type there for the same light.'), programs));

  let turn = 0;
  let begun = false;
  async function begin() {
    begun = true;
    try {
      const { entries } = reportOf(await commands.run(['list', 'policies', '--json']));
      policy.setEntries(entries.map(({ name, summary }) => [name, `${name}: ${summary.replace(/ \(.*/, '')}`]), state.policy);
    } catch { /* the choice stays as it is */ }
  }

  async function update() {
    if (currentTab() !== 'units') return;
    if (!begun) begin();
    const own = ++turn;
    const words = ['units', state.value || '0', ...(state.shape ? ['--shape', state.shape] : []), ...(state.policy !== 'physical' ? ['--policy', state.policy] : [])];
    try {
      const report = reportOf(await commands.run([...words, ...(state.to ? ['--to', state.to] : []), '--json']));
      if (own !== turn) return;
      const rows = report.results.map(({ unit, value }) => el('tr', {},
        el('th', { scope: 'row' }, unitNames[unit.split('@')[0]] ?? unit),
        el('td', { 'data-unit': unit }, value === null ? el('span', { class: 'muted' }, 'none') : exactNumber(value), el('span', { class: 'unit' }, ` ${unit === 'ev' ? 'EV100' : unit === 'nt' ? 'cd/m² (nt)' : unit}`))));
      fill(result, el('table', { class: 'facts-table' }, el('caption', { class: 'hidden' }, 'Result'), el('tbody', {}, ...rows)),
        report.diagnostics?.length ? problem({ diagnostics: report.diagnostics }) : null);
      const answer = await commands.run([...words, '--for', 'all', '--json']);
      if (own !== turn) return;
      fill(programs, answer.status === 0 ? programTable(reportOf(answer).programs) : problem(errorOf(answer)));
    } catch (error) {
      if (own !== turn || error instanceof Cancelled) return;
      fill(result, problem(error));
      fill(programs);
    }
  }
  on('tab', (name) => name === 'units' && update());
  return root;
}
