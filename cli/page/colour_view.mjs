// Colour temperature: a slider over temperature and Duv, with the colour, x,y and all that `gonio cct` says.
import { card, debounce, el, field, fill, problem, segmented } from './dom.mjs';
import { change, commands, currentTab, on, say } from './app.mjs';
import { Cancelled, reportOf } from './engine.mjs';
import { exactNumber } from './numbers.mjs';

const from_K = 1500;
const to_K = 12000;

// Linear Rec.709 to what a canvas or a style takes: brightest component 1, what is out of the gamut clipped.
function cssColor(rgb) {
  const brightest = Math.max(...rgb, 1e-9);
  const encoded = rgb.map((value) => {
    const v = Math.min(1, Math.max(0, value / brightest));
    return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  });
  return `rgb(${encoded.join(' ')})`;
}

export function colourView() {
  const state = { kelvin: 3000, duv: 0, locus: 'planckian' };
  const range = el('input', { type: 'range', min: from_K, max: to_K, step: 10, value: state.kelvin, class: 'wide kelvin' });
  const number = el('input', { type: 'number', min: 1000, max: 100000, step: 10, value: state.kelvin, class: 'number-box', 'aria-label': 'Colour temperature in kelvin' });
  const duvRange = el('input', { type: 'range', min: -0.02, max: 0.02, step: 0.0005, value: 0, class: 'wide duv' });
  const duvNumber = el('input', { type: 'number', min: -0.05, max: 0.05, step: 0.001, value: 0, class: 'number-box', 'aria-label': 'Duv' });
  const swatch = el('div', { class: 'swatch', role: 'img', 'aria-label': 'The colour' });
  const swatchText = el('p', { class: 'swatch-text' });
  const result = el('div', { class: 'result' });
  const give = debounce(20, () => update());
  const link = (a, b, key) => {
    for (const [one, other] of [[a, b], [b, a]])
      one.addEventListener('input', () => {
        if (one.value === '' || !Number.isFinite(Number(one.value))) return;
        state[key] = Number(one.value);
        other.value = one.value;
        give();
      });
  };
  link(range, number, 'kelvin');
  link(duvRange, duvNumber, 'duv');
  const use = el('button', { type: 'button', onclick: () => {
    change('color', (document) => { document.rig.lights[document.active].color = state.duv ? `${state.kelvin}K/${state.duv}` : `${state.kelvin}K`; });
    say('The light on the stage has this colour');
  } }, 'Give it to the light on the stage');
  const root = el('div', { class: 'tool-grid' },
    card('Colour temperature', el('div', { class: 'form pad' }, swatch, swatchText,
      field('Temperature [K]', range), number, field('Duv, the distance from the Planckian locus: above it greener', duvRange), duvNumber,
      segmented('Locus', [['planckian', 'Planckian'], ['daylight', 'Daylight'], ['blend', 'Blend']], state.locus, (locus) => { state.locus = locus; update(); }), use)),
    card('Chromaticity', result));

  const row = (label, key, value, unit = '') => el('tr', {}, el('th', { scope: 'row' }, label), el('td', { 'data-key': key },
    typeof value === 'boolean' ? (value ? 'yes' : 'no') : exactNumber(value), unit ? el('span', { class: 'unit' }, unit) : null));

  let turn = 0;
  async function update() {
    if (currentTab() !== 'colour') return;
    const own = ++turn;
    try {
      const words = ['cct', `${state.kelvin}K${state.duv ? `/${state.duv}` : ''}`, '--json', ...(state.locus === 'planckian' ? [] : ['--locus', state.locus])];
      const report = reportOf(await commands.run(words));
      if (own !== turn) return;
      if (!report.xy) throw Object.assign(new Error('no colour'), { diagnostics: report.diagnostics });
      swatch.style.background = cssColor(report.rgb);
      swatchText.textContent = `${report.cct_K} K, Duv ${report.duv}: x ${report.xy[0].toFixed(4)}, y ${report.xy[1].toFixed(4)}${report.in_gamut ? '' : ' (outside the gamut of the display)'}`;
      const rows = [
        row('Temperature', 'cct_K', report.cct_K, ' K'), row('Duv', 'duv', report.duv),
        row('x', 'xy.0', report.xy[0]), row('y', 'xy.1', report.xy[1]),
        row('u′', 'uv_prime.0', report.uv_prime[0]), row('v′', 'uv_prime.1', report.uv_prime[1]),
        row('R', 'rgb.0', report.rgb[0]), row('G', 'rgb.1', report.rgb[1]), row('B', 'rgb.2', report.rgb[2]),
        row('Inside the gamut', 'in_gamut', report.in_gamut),
      ];
      fill(result, el('table', { class: 'facts-table chromaticity' }, el('caption', { class: 'hidden' }, 'Chromaticity'), el('tbody', {}, ...rows)),
        report.diagnostics?.length ? problem({ diagnostics: report.diagnostics }) : null);
    } catch (error) {
      if (own === turn && !(error instanceof Cancelled)) fill(result, problem(error));
    }
  }

  // The slider's track shows the colours that it goes through.
  async function paintTrack() {
    try {
      const reports = reportOf(await commands.run(['cct', `${from_K}K:${to_K}K:750K`, '--json']));
      range.style.setProperty('--track', `linear-gradient(to right, ${reports.map((each) => cssColor(each.rgb)).join(', ')})`);
      const around = await Promise.all([-0.02, 0, 0.02].map(async (duv) => reportOf(await commands.run(['cct', `4000K/${duv}`, '--json']))));
      duvRange.style.setProperty('--track', `linear-gradient(to right, ${around.map((each) => cssColor(each.rgb)).join(', ')})`);
    } catch { /* the track stays plain */ }
  }
  let painted = false;
  on('tab', (name) => {
    if (name !== 'colour') return;
    update();
    if (!painted) paintTrack();
    painted = true;
  });
  return root;
}
