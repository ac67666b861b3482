// The facts of a profile: every number of `gonio info --json --all`, in the order in which people ask for them.
import { card, el, fill, select } from './dom.mjs';
import { on, prefer, prefs } from './app.mjs';
import { briefNumber, exactNumber, fluxUnits, lengthUnits } from './numbers.mjs';

const symmetries = {
  none: 'none', axial: 'axial: the same in every plane', quadrant: 'quadrants', bilateral: 'bilateral',
};

// [key, label, unit, help]; a key with a dot goes into an object.
const groups = [
  ['Light', [
    ['flux_lm', 'Luminous flux', 'flux', 'The integral of the table over the sphere'],
    ['zonal_flux_lm', 'Zonal flux', 'flux', 'The same by zonal constants, as older programs compute it'],
    ['declared_flux_lm', 'Declared flux', 'flux', 'Lumens of the lamps, as the file states them'],
    ['absolute', 'Absolute photometry', ''],
    ['input_W', 'Input power', 'W'],
    ['efficacy_lm_per_W', 'Efficacy', 'lm/W'],
  ]],
  ['Peak and beam', [
    ['peak_cd', 'Peak intensity', 'cd'],
    ['peak_c_deg', 'Peak at C', '°'],
    ['peak_gamma_deg', 'Peak at γ', '°'],
    ['center_beam_cd', 'Centre beam', 'cd'],
    ['beam_angle_deg', 'Beam angle C0–C180', '°', 'Full angle to half of the peak'],
    ['beam_angle_c90_deg', 'Beam angle C90–C270', '°'],
    ['field_angle_deg', 'Field angle C0–C180', '°', 'Full angle to a tenth of the peak'],
    ['field_angle_c90_deg', 'Field angle C90–C270', '°'],
    ['beam_angle_cie_deg', 'CIE beam C0–C180', '°'],
    ['beam_angle_cie_c90_deg', 'CIE beam C90–C270', '°'],
    ['nema_horizontal', 'NEMA horizontal', ''],
    ['nema_vertical', 'NEMA vertical', ''],
  ]],
  ['File', [
    ['format', 'Format', ''],
    ['version', 'Version', ''],
    ['photometry', 'Photometry type', ''],
    ['planes', 'C-planes', ''],
    ['gammas', 'Gamma angles', ''],
    ['symmetry', 'Symmetry', ''],
    ['declared_symmetry', 'Declared symmetry', ''],
    ['intensity_unit', 'Unit of intensity', ''],
    ['flux_unit', 'Unit of flux', ''],
  ]],
  ['Luminaire', [
    ['luminous_opening.shape', 'Luminous opening', ''],
    ['luminous_opening.width_m', 'Opening width', 'length'],
    ['luminous_opening.length_m', 'Opening length', 'length'],
    ['luminous_opening.height_m', 'Opening height', 'length'],
    ['point_distance_m', 'A point within 1 % from', 'length', 'From this distance on the luminaire lights like a point, within 1 %'],
  ]],
];

const zoneLabel = (key) => `${key.replace('-', '°–')}°`;

export function valueOf(info, key) {
  return key.split('.').reduce((value, part) => value?.[part], info);
}

export const numericFacts = groups.flatMap(([, rows]) => rows);

// A value with its unit: all digits as they are; rounded in a unit of
// choice, or when that was asked for.
export function quantity(value, unit, brief = false) {
  if (value === null || value === undefined) return el('span', { class: 'muted' }, 'none');
  if (typeof value === 'boolean') return el('span', {}, value ? 'yes' : 'no');
  if (typeof value !== 'number') return el('span', {}, symmetries[value] ?? String(value));
  let shown = unit;
  let factor = 1;
  if (unit === 'length') {
    shown = prefs.length;
    factor = lengthUnits[prefs.length] ?? 1;
  } else if (unit === 'flux') {
    shown = prefs.flux;
    factor = fluxUnits[prefs.flux] ?? 1;
  }
  const exact = factor === 1 && prefs.digits === 'exact' && !brief;
  const number = exact ? exactNumber(value) : el('span', { class: 'number', title: String(value) }, briefNumber(value / factor, 5));
  return el('span', {}, number, shown ? el('span', { class: 'unit' }, shown === '°' ? '°' : ` ${shown}`) : null);
}

function row(label, value, { key, help, raw } = {}) {
  return el('tr', {}, el('th', { scope: 'row', title: help }, label),
    el('td', { 'data-key': key, 'data-raw': raw === undefined ? undefined : JSON.stringify(raw) }, value));
}

function group(title, rows) {
  return el('tbody', {}, el('tr', { class: 'group' }, el('th', { scope: 'rowgroup', colspan: 2 }, title)), ...rows);
}

function table(info) {
  const bodies = groups.map(([title, rows]) => group(title, rows
    .filter(([key]) => valueOf(info, key) !== undefined)
    .map(([key, label, unit, help]) => {
      const value = valueOf(info, key);
      return row(label, quantity(value, unit), { key, help, raw: value });
    })));
  const lamps = (info.lamps ?? []).flatMap((lamp, i) => {
    const name = info.lamps.length > 1 ? `Lamp ${i + 1}: ` : '';
    return [
      ['count', 'Lamps', ''], ['type', 'Lamp type', ''], ['flux_lm', 'Lamp flux', 'flux'], ['cct_K', 'Colour temperature', 'K'],
      ['cri', 'Colour rendering', ''], ['input_W', 'Lamp input power', 'W'],
    ].filter(([key]) => lamp[key] !== null && lamp[key] !== undefined && lamp[key] !== '')
      .map(([key, label, unit]) => row(name + label, quantity(lamp[key], unit), { key: `lamps.${i}.${key}`, raw: lamp[key] }));
  });
  if (lamps.length) bodies.push(group('Lamps', lamps));
  if (info.zones_lm) bodies.push(group('Zones', Object.entries(info.zones_lm).map(([key, value]) =>
    row(zoneLabel(key), quantity(value, 'flux'), { key: `zones_lm.${key}`, raw: value }))));
  const more = [];
  info.cie_flux_code_percent?.forEach((value, i) => more.push(row(`CIE flux code N${i + 1}`, quantity(value, '%'), { key: `cie_flux_code_percent.${i}`, raw: value })));
  const spacing = { c0_180: 'C0–C180', c90_270: 'C90–C270', diagonal: 'diagonal' };
  for (const [key, value] of Object.entries(info.spacing_criterion ?? {}))
    more.push(row(`Spacing criterion ${spacing[key] ?? key}`, quantity(value, ''), { key: `spacing_criterion.${key}`, raw: value }));
  for (const [key, value] of Object.entries(info.lcs_lm ?? {}))
    more.push(row(`LCS ${key}`, quantity(value, 'flux'), { key: `lcs_lm.${key}`, raw: value }));
  if (info.lcs_front_c_deg !== undefined && info.lcs_front_c_deg !== null)
    more.push(row('LCS front at C', quantity(info.lcs_front_c_deg, '°'), { key: 'lcs_front_c_deg', raw: info.lcs_front_c_deg }));
  if (more.length) bodies.push(group('Classification', more));
  if (info.figure_rules) bodies.push(group('Figures', figureRows(info)));
  return el('table', { class: 'facts-table' }, el('caption', { class: 'hidden' }, 'Facts of the profile'), ...bodies);
}

// [key, label, unit]; what a luminaire is planned by.
const figures = [
  ['light_output_ratios.lor', 'Light output ratio LOR', ''],
  ['light_output_ratios.dlor', 'Downward DLOR', ''],
  ['light_output_ratios.ulor', 'Upward ULOR', ''],
  ['upward_light_ratio', 'Upward share ULR', ''],
  ['distribution_class', 'Distribution, DIN 5040', ''],
  ['bug.rating', 'BUG rating', ''],
  ['bug.rating_type_v', 'BUG rating as type V', ''],
  ['cut_off', 'Cut-off class', ''],
  ['luminous_intensity_class', 'Intensity class by its own flux', ''],
  ['luminous_intensity_class_lamps', 'Intensity class by the lamps’ flux', ''],
  ['glare_index.class', 'Glare index class', ''],
  ['glare_index.cd_per_m', 'Glare index at 85°', 'cd/m'],
  ['ugr_correction', 'In the UGR tables for the lamps’ flux', ''],
];

// The figures with one value; the rule of each is its help, and the reason for one that there is not.
function figureRows(info) {
  return figures.map(([key, label, unit]) => {
    const name = key.split('.')[0];
    const value = valueOf(info, key);
    const missing = info.missing_figures?.[name];
    const shown = missing ? el('span', { class: 'muted' }, missing) : quantity(value, unit);
    return row(label, shown, { key, help: info.figure_rules?.[name], raw: value ?? null });
  });
}

// A table of numbers behind its title: rows and columns have names, `digits` decimals.
function numbersTable(title, corner, columns, rows, values, digits, help) {
  return el('details', { class: 'figure-table' }, el('summary', { title: help }, title), el('div', { class: 'scroll' },
    el('table', {}, el('caption', { class: 'hidden' }, title),
      el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, corner), ...columns.map((name) => el('th', { scope: 'col' }, name)))),
      el('tbody', {}, ...values.map((numbers, i) => el('tr', {}, el('th', { scope: 'row' }, rows[i]),
        ...numbers.map((number) => el('td', {}, number.toFixed(digits)))))))));
}

// UGR below 10 is of no use, as catalogues print it.
function ugrTable(info) {
  const table = numbersTable('UGR table, spacing 0.25 H', 'X × Y', [...info.ugr_reflectances, ...info.ugr_reflectances],
    info.ugr_rooms.map((room) => room.replace('x', 'H × ') + 'H'), info.ugr_table, 1, info.figure_rules?.ugr_table);
  for (const cell of table.querySelectorAll('td')) if (Number(cell.textContent) < 10) cell.textContent = '<10';
  table.querySelector('thead').prepend(el('tr', {}, el('td'), el('th', { scope: 'colgroup', colspan: 5 }, 'crosswise'), el('th', { scope: 'colgroup', colspan: 5 }, 'endwise')));
  return table;
}

function figureTables(info) {
  const tables = [];
  if (info.ugr_table) tables.push(ugrTable(info));
  if (info.utilisation_factors) tables.push(numbersTable('Utilisation factors', 'k', info.utilisation_reflectances,
    info.room_indices.map(String), info.utilisation_factors, 2, info.figure_rules?.utilisation_factors));
  return tables;
}

export function factsCard() {
  const body = el('div', { class: 'facts-body' });
  const section = card('Facts', body);
  section.classList.add('facts-card');
  const choose = (key, label, entries) => select(label, entries, prefs[key], (value) => prefer(key, value), { class: 'small' });
  const digits = choose('digits', 'Digits', [['exact', 'all digits'], ['rounded', 'rounded']]);
  const length = choose('length', 'Unit of length', Object.keys(lengthUnits).map((unit) => [unit, unit]));
  const flux = choose('flux', 'Unit of flux', Object.keys(fluxUnits).map((unit) => [unit, unit]));
  section.head.append(el('span', { class: 'head-tools' }, digits, flux, length));
  let current;
  section.show = (file) => {
    current = file;
    if (file?.info) fill(body, table(file.info), ...figureTables(file.info));
    else fill(body, el('p', { class: 'muted pad' }, file?.state === 'reading' ? 'Reading…' : 'No facts: the file cannot be read.'));
  };
  on('prefs', () => {
    if (current) section.show(current);
    digits.value = prefs.digits;
    length.value = prefs.length;
    flux.value = prefs.flux;
  });
  return section;
}
