// The controls of the lit stage. They show the document and change it; what is wrong with a value the tool says.
import { debounce, el, field, fill, segmented, select } from './dom.mjs';
import { activeLight, change, commands, doc, fileById, files, on, prefer, prefs, say, selectFile, selected, shapeOf } from './app.mjs';
import { reportOf } from './engine.mjs';
import { anglesOf, directionOf, stageOf, stages } from './stages.mjs';

const first_K = 4000;

function numberField(label, { min, max, step, unit = '', digits = 2, slider = true }, set) {
  const number = el('input', { type: 'number', min, max, step, class: 'number-box' });
  const range = slider ? el('input', { type: 'range', min, max, step, 'aria-label': label }) : null;
  const give = (value) => {
    if (value === '' || !Number.isFinite(Number(value))) return;
    set(Number(value));
  };
  number.addEventListener('change', () => give(number.value));
  number.addEventListener('input', () => document.activeElement === number && give(number.value));
  range?.addEventListener('input', () => {
    number.value = range.value;
    give(range.value);
  });
  const control = field(label, number);
  control.append(el('div', { class: 'number-field' }, range, number, unit ? el('span', { class: 'unit' }, unit) : null));
  control.show = (value) => {
    const text = String(Number(value.toFixed(digits)));
    if (document.activeElement !== number) number.value = text;
    if (range && document.activeElement !== range) range.value = text;
  };
  control.enable = (enabled) => {
    number.disabled = !enabled;
    if (range) range.disabled = !enabled;
  };
  return control;
}

function textField(label, { placeholder = '', list, title } = {}, set) {
  const input = el('input', { type: 'text', placeholder, list, title, spellcheck: 'false', autocomplete: 'off' });
  const give = debounce(250, () => set(input.value.trim()));
  input.addEventListener('input', give);
  const control = field(label, input);
  control.show = (value) => {
    if (document.activeElement !== input) input.value = value;
  };
  control.input = input;
  return control;
}

const section = (title, ...children) => el('fieldset', {}, el('legend', {}, title), ...children);

export function stagePanel(view) {
  const light = (key, edit) => change(key, (document) => edit(document.rig.lights[document.active]));
  const shown = [];
  const keep = (control, show) => {
    shown.push(() => show(control));
    return control;
  };

  // ---- light
  const which = keep(field('Light', select('Light', [], '0', (value) => change('active', (document) => { document.active = Number(value); }))), (control) => {
    const input = control.querySelector('select');
    input.setEntries(doc.rig.lights.map((each, i) => [String(i), each.name ?? `light ${i + 1}`]), String(doc.active));
    control.hidden = doc.rig.lights.length < 2;
  });
  const source = keep(field('Source', select('Source', [], '', (value) => {
    if (value === 'shape') light('shape', (each) => {
      each.shape = 'sphere:r=10cm';
      each.intensity ??= '800lm';
    });
    else if (fileById(Number(value)) === selected()) light('shape', (each) => { each.shape = shapeOf(selected()); });
    else {
      change('shape', (document) => { document.rig.lights[document.active].shape = ''; });
      selectFile(Number(value));
      change('shape', () => {});
    }
  })), (control) => {
    const shape = activeLight().shape ?? '';
    const used = files.find((file) => shape.startsWith(`ies:${file.path}`));
    control.querySelector('select').setEntries([...files.map((file) => [String(file.id), file.name]), ['shape', 'a shape…']], used ? String(used.id) : shape ? 'shape' : '');
  });
  const shape = keep(textField('Shape', { list: 'shapes', placeholder: 'sphere:r=10cm' }, (value) => light('shape', (each) => { each.shape = value; })), (control) => {
    const text = activeLight().shape ?? '';
    control.hidden = /^ies:/.test(text) || text === '';
    control.show(text);
  });
  const intensity = keep(textField('Intensity', { list: 'amounts', placeholder: 'as measured', title: '1200lm, 800cd, 300lx@2m, 60W@90lm/W' }, (value) => light('intensity', (each) => {
    if (value) each.intensity = value;
    else delete each.intensity;
  })), (control) => {
    control.show(activeLight().intensity ?? '');
    control.input.placeholder = /^ies:/.test(activeLight().shape ?? '') ? 'as measured' : '800lm';
  });

  const share = (value) => (typeof value === 'string' ? parseFloat(value) / 100 : value ?? 1);
  const dimming = keep(numberField('Dimming', { min: 0, max: 100, step: 1, unit: '%', digits: 1 }, (value) => light('dimming', (each) => {
    if (value === 100) delete each.dimming;
    else each.dimming = Math.min(100, Math.max(0, value)) / 100;
  })), (control) => control.show(100 * share(activeLight().dimming)));

  // ---- where it is
  const position = ['X', 'Y', 'Z'].map((axis, i) => keep(numberField(axis, { min: -20, max: 20, step: 0.05, unit: 'm', slider: false }, (value) => light(`position-${axis}`, (each) => {
    const next = [...activeLight().position];
    next[i] = value;
    each.position = next;
  })), (control) => control.show(activeLight().position[i])));
  const turn = (edit) => light('turn', (each) => {
    const angles = anglesOf(activeLight().direction);
    edit(angles);
    each.direction = directionOf(angles.tilt, angles.azimuth);
    delete each.target;
    delete each.up;
  });
  let azimuth = 0; // kept where the tilt is 0 and it has no meaning
  const tilt = keep(numberField('Tilt from straight down', { min: 0, max: 180, step: 1, unit: '°', digits: 1 }, (value) => turn((angles) => {
    angles.azimuth = angles.tilt > 0.01 ? angles.azimuth : azimuth;
    angles.tilt = value;
  })), (control) => control.show(anglesOf(activeLight().direction).tilt));
  const towards = keep(numberField('Tilted towards', { min: -180, max: 180, step: 1, unit: '°', digits: 1 }, (value) => {
    azimuth = value;
    turn((angles) => { angles.azimuth = value; });
  }), (control) => {
    const angles = anglesOf(activeLight().direction);
    control.show(angles.tilt > 0.01 ? angles.azimuth : azimuth);
  });
  const rotate = keep(numberField('Rotated about its axis', { min: -180, max: 180, step: 1, unit: '°', digits: 1 }, (value) => light('rotate', (each) => {
    if (value) each.rotate = `${value}deg`;
    else delete each.rotate;
  })), (control) => control.show(parseFloat(activeLight().rotate ?? '0') || 0));

  // ---- colour
  const temperature = () => /^(\d+(?:\.\d+)?)K(?:\/(-?[\d.]+(?:e-?\d+)?))?$/.exec(activeLight().color ?? '');
  const setColor = (kelvin, duv) => light('color', (each) => { each.color = duv ? `${kelvin}K/${duv}` : `${kelvin}K`; });
  const coloured = el('input', { type: 'checkbox', onchange: () => {
    if (coloured.checked) setColor(first_K, 0);
    else light('color', (each) => { delete each.color; });
  } });
  keep(coloured, () => { coloured.checked = Boolean(activeLight().color); });
  const kelvin = keep(numberField('Colour temperature', { min: 1500, max: 12000, step: 50, unit: 'K', digits: 0 }, (value) => setColor(value, Number(temperature()?.[2] ?? 0))), (control) => {
    control.show(Number(temperature()?.[1] ?? 6504));
    control.enable(!activeLight().color || Boolean(temperature()));
  });
  const duv = keep(numberField('Duv', { min: -0.02, max: 0.02, step: 0.001, digits: 4 }, (value) => setColor(Number(temperature()?.[1] ?? first_K), value)), (control) => {
    control.show(Number(temperature()?.[2] ?? 0));
    control.enable(Boolean(temperature()));
  });

  // ---- the stage
  const stage = keep(field('Stage', select('Stage', Object.keys(stages).map((name) => [name, name]), 'room', (value) => change('stage', (document) => {
    document.rig.stage = value;
    delete document.rig.camera;
    delete document.rig.materials;
    delete document.rig.emits;
    const each = document.rig.lights[document.active];
    for (const key of ['position', 'direction', 'target', 'up']) delete each[key];
  }))), (control) => {
    const named = typeof doc.rig.stage === 'object' ? [['custom', doc.rig.stage.name ?? 'custom']] : [];
    control.querySelector('select').setEntries([...Object.keys(stages).map((name) => [name, name]), ...named], named.length ? 'custom' : doc.rig.stage ?? 'floor');
  });
  const sky = keep(textField('Sky', { placeholder: 'none', list: 'skies', title: '500lx, cie:12,sun=180/40,horizontal=20klx' }, (value) => change('sky', (document) => {
    if (value) document.rig.sky = value;
    else delete document.rig.sky;
  })), (control) => control.show(doc.rig.sky ?? ''));
  const materials = el('div', { class: 'materials' });
  let materialRows = '';
  keep(materials, () => {
    const names = stageOf(doc.rig).surfaces;
    if (names.join() !== materialRows) {
      materialRows = names.join();
      fill(materials, ...names.map((name) => {
        const row = textField(name, { placeholder: "the stage's own", list: 'materials' }, (value) => change(`material-${name}`, (document) => {
          const all = { ...document.rig.materials };
          if (value) all[name] = value;
          else delete all[name];
          if (Object.keys(all).length) document.rig.materials = all;
          else delete document.rig.materials;
        }));
        row.dataset.surface = name;
        return row;
      }));
      [...materials.children].forEach((row) => { row.show = (value) => { const input = row.querySelector('input'); if (document.activeElement !== input) input.value = value; }; });
    }
    for (const row of materials.children) row.show(String(doc.rig.materials?.[row.dataset.surface] ?? ''));
  });

  // ---- display
  const setView = (key, value) => change(`view-${key}`, (document) => { document.view[key] = value; });
  const mode = keep(segmented('Display mode', [['beauty', 'Beauty'], ['falsecolour', 'False colour'], ['isolux', 'Isolux']], doc.view.mode, (value) => setView('mode', value)), (control) => control.set(doc.view.mode));
  const unit = segmented('Unit of illuminance', [['lx', 'lx'], ['fc', 'fc']], prefs.illuminance, (value) => prefer('illuminance', value));
  on('prefs', () => unit.set(prefs.illuminance));
  const automatic = el('input', { type: 'checkbox', onchange: () => setView('exposure', automatic.checked ? 'auto' : Math.round(lastExposure * 10) / 10) });
  let lastExposure = 8;
  view.addEventListener('picture', ({ detail }) => {
    if (!Number.isFinite(detail.ev100)) return;
    lastExposure = detail.ev100;
    if (doc.view.exposure === 'auto') exposure.show(detail.ev100);
  });
  keep(automatic, () => { automatic.checked = doc.view.exposure === 'auto'; });
  const exposure = keep(numberField('Exposure', { min: -4, max: 18, step: 0.1, unit: 'EV100', digits: 1 }, (value) => setView('exposure', value)), (control) => {
    if (doc.view.exposure !== 'auto') control.show(doc.view.exposure);
    control.enable(doc.view.mode !== 'falsecolour');
  });
  const choice = (key, label, entries, read = (value) => value) => keep(field(label, select(label, entries, String(doc.view[key]), (value) => setView(key, read(value)))), (control) => {
    control.querySelector('select').value = String(doc.view[key]);
  });
  const tone = choice('view', 'View', [['Standard', 'Standard'], ['Filmic', 'Filmic']]);
  const shadows = choice('shadows', 'Shadows', [['soft', 'soft'], ['hard', 'hard'], ['off', 'off']]);
  const bounces = choice('bounces', 'Bounces of light', [['-1', 'all'], ['3', '3'], ['2', '2'], ['1', '1'], ['0', 'none']], Number);

  const panel = el('form', { class: 'panel', 'aria-label': 'Controls of the stage', onsubmit: (event) => event.preventDefault() },
    section('Display mode', el('div', { class: 'row' }, mode, unit), exposure, el('label', { class: 'check' }, automatic, ' automatic exposure'), el('div', { class: 'two' }, tone, shadows), bounces),
    section('Light', which, source, shape, intensity, dimming, el('label', { class: 'check' }, coloured, ' colour by its temperature'), kelvin, duv),
    section('Position and direction', el('div', { class: 'three' }, ...position), tilt, towards, rotate),
    section('Stage', stage, sky),
    section('Materials', materials));

  const sync = () => shown.forEach((show) => show());
  on('doc select files tab', sync);
  sync();
  let offered = false;
  on('tab', (name) => {
    if (name === 'stage' && !offered) offerNames();
    offered ||= name === 'stage';
  });
  return panel;
}

// What may be typed, from the tool's own lists.
async function offerNames() {
  const lists = [['materials', 'materials'], ['shapes', 'shapes'], ['skies', 'skies']];
  document.body.append(el('datalist', { id: 'amounts' }, ...['500lm', '800lm', '1200lm', '3000lm', '1000cd', '300lx@2m', '60W@90lm/W'].map((value) => el('option', { value }))));
  for (const [id, list] of lists) {
    try {
      const { entries } = reportOf(await commands.run(['list', list, '--json']));
      const typed = { shapes: ['sphere:r=10cm', 'disk:r=20cm', 'rect:w=60cm,h=60cm', 'tube:r=1.3cm,l=1.2m', 'cylinder:r=5cm,l=30cm', 'spot:outer=40deg,inner=25deg', 'point'], skies: ['500lx', 'cie:12,sun=180/40,horizontal=20klx'] }[id] ?? entries.map((entry) => entry.name);
      document.body.append(el('datalist', { id }, ...typed.map((value) => el('option', { value }))));
    } catch (error) {
      say(error.message);
    }
  }
}
