// Two profiles side by side: one diagram of both, their facts with the differences, and the same stage under each.
import { card, el, field, fill, problem, segmented, select, showSvg, textOf } from './dom.mjs';
import { commands, doc, fileById, files, on, currentTab, shapeOf, selected } from './app.mjs';
import { diagnosticsOf, Cancelled } from './engine.mjs';
import { drawDiagram, describe } from './diagrams.mjs';
import { numericFacts, quantity, valueOf } from './facts.mjs';
import { renderOptions, Renderer, sceneOf } from './stage_view.mjs';
import { briefNumber } from './numbers.mjs';


// Angles and counts by how much, other amounts in per cent of the first.
function changeText(from, to, unit) {
  if (Math.abs(to - from) <= 1e-9 * Math.abs(from)) return '≈';
  const sign = to > from ? '+' : '−';
  if (unit === '°' || unit === '' || from === 0) return `${sign}${briefNumber(Math.abs(to - from), 3)}${unit === '°' ? '°' : ''}`;
  return `${sign}${briefNumber(Math.abs((100 * (to - from)) / from), 3)} %`;
}

export function compareView() {
  const state = { a: undefined, b: undefined, kind: 'polar', perKlm: false };
  const renderer = new Renderer();
  const image = el('img', { class: 'diagram invertible', alt: '', width: 720, height: 720 });
  const frame = el('div', { class: 'diagram-frame' }, image);
  const perKlm = el('input', { type: 'checkbox', onchange: () => { state.perKlm = perKlm.checked; update(); } });
  const choose = (key) => select(key === 'a' ? 'First profile' : 'Second profile', [], '', (value) => {
    state[key] = Number(value);
    update();
  });
  const [selectA, selectB] = [choose('a'), choose('b')];
  const swap = el('button', { type: 'button', onclick: () => {
    [state.a, state.b] = [state.b, state.a];
    refresh();
  } }, 'Swap');
  const table = el('div', { class: 'facts-body' });
  const verdict = el('div', { class: 'pad' });
  const pictures = ['a', 'b'].map(() => {
    const canvas = el('canvas', { width: 480, height: 320, role: 'img', 'aria-label': 'Stage' });
    const label = el('figcaption', {});
    return { canvas, label, figure: el('figure', { class: 'shot' }, canvas, label) };
  });
  const empty = el('p', { class: 'pad muted' }, 'Open two or more profiles to compare them.');
  const content = el('div', { class: 'compare-grid' }, el('div', { class: 'column' },
    card('Diagram', segmented('Diagram', [['polar', 'Polar'], ['cartesian', 'Cartesian']], 'polar', (kind) => { state.kind = kind; update(); }), frame,
      el('div', { class: 'card-foot' }, el('label', { class: 'check' }, perKlm, ' per 1000 lm'))),
    card('On the stage', el('div', { class: 'shots' }, ...pictures.map((each) => each.figure)),
      el('p', { class: 'pad muted' }, 'The stage, the camera and the display mode are those of the Stage view; both at the same exposure.'))),
    card('Differences', verdict, table));
  const root = el('div', {}, el('div', { class: 'compare-head' }, field('First', selectA), swap, field('Second', selectB)), empty, content);

  function refresh() {
    const readable = files.filter((file) => file.info);
    const has = (id) => readable.some((file) => file.id === id);
    if (!has(state.a)) state.a = (selected()?.info ? selected() : readable[0])?.id;
    if (!has(state.b) || state.b === state.a) state.b = readable.find((file) => file.id !== state.a)?.id ?? state.b;
    const entries = readable.map((file) => [String(file.id), file.name]);
    selectA.setEntries(entries, String(state.a));
    selectB.setEntries(entries, String(state.b));
    empty.hidden = readable.length >= 2;
    content.hidden = root.firstChild.hidden = readable.length < 2;
    if (readable.length >= 2) update();
  }

  function rows(a, b) {
    return numericFacts.map(([key, label, unit]) => [label, unit, valueOf(a.info, key), valueOf(b.info, key)])
      .filter(([, , va, vb]) => (va ?? vb ?? null) !== null)
      .map(([label, unit, va, vb]) => {
        const numbers = typeof va === 'number' && typeof vb === 'number';
        const difference = va === vb ? '=' : numbers ? changeText(va, vb, unit) : 'differs';
        return el('tr', { class: va === vb ? '' : 'differs' }, el('th', { scope: 'row' }, label), el('td', {}, quantity(va, unit, true)), el('td', {}, quantity(vb, unit, true)), el('td', { class: 'difference' }, difference));
      });
  }

  let turn = 0;
  async function update() {
    const own = ++turn;
    const [a, b] = [fileById(state.a), fileById(state.b)];
    if (!a || !b || currentTab() !== 'compare') return;
    fill(table, el('table', { class: 'facts-table compare-table' },
      el('thead', {}, el('tr', {}, el('td', {}), el('th', { scope: 'col' }, a.name), el('th', { scope: 'col' }, b.name), el('th', { scope: 'col' }, 'Difference'))),
      el('tbody', {}, ...rows(a, b))));
    frame.querySelector('.problem')?.remove();
    try {
      const svg = await drawDiagram(a === b ? [a] : [a, b], state.kind, { perKlm: state.perKlm });
      if (own !== turn) return;
      image.hidden = false;
      showSvg(image, svg, `${describe[state.kind]} of ${a.name} and ${b.name}`);
      const answer = await commands.run(['compare', a.path, b.path], { [a.path]: a.bytes, [b.path]: b.bytes }, { label: 'comparing' });
      if (own !== turn) return;
      const text = textOf(answer.stdout).trim() || diagnosticsOf(answer.stderr).map((entry) => entry.message).join('\n');
      fill(verdict, el('pre', { class: 'tool-text', tabindex: 0, role: 'group', 'aria-label': 'What gonio compare says' }, text));
    } catch (error) {
      if (own === turn && !(error instanceof Cancelled)) {
        image.hidden = true;
        frame.append(problem(error));
      }
    }
    await shoot(own, [a, b]);
  }

  // The exposure of the first for both, so that the brighter one looks brighter.
  async function shoot(own, pair) {
    let exposure = doc.view.exposure;
    for (const [i, file] of pair.entries()) {
      const { canvas, label } = pictures[i];
      label.textContent = file.name;
      canvas.setAttribute('aria-label', `Stage lit by ${file.name}`);
      const document = JSON.parse(JSON.stringify(doc));
      document.rig.lights[document.active].shape = shapeOf(file);
      document.view.exposure = exposure;
      const width = Math.max(240, Math.min(960, Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2)) || 480));
      try {
        const picture = await renderer.render(sceneOf(document), renderOptions(document, width, Math.round((width * 2) / 3)), { label: 'comparing', patience: 120000 });
        if (own !== turn) return;
        Object.assign(canvas, { width: picture.width, height: picture.height });
        canvas.getContext('2d').putImageData(new ImageData(picture.rgba, picture.width, picture.height), 0, 0);
        if (exposure === 'auto' && Number.isFinite(picture.ev100)) exposure = picture.ev100;
      } catch (error) {
        if (own === turn && !(error instanceof Cancelled)) label.textContent = `${file.name}: ${error.message}`;
      }
    }
  }

  on('files file', () => currentTab() === 'compare' && refresh());
  on('select', (file) => {
    if (file?.info && file.id !== state.b) state.a = file.id;
    if (currentTab() === 'compare') refresh();
  });
  on('doc', () => currentTab() === 'compare' && shoot(++turn, [fileById(state.a), fileById(state.b)].filter(Boolean)));
  on('prefs', () => currentTab() === 'compare' && update());
  on('tab', (name) => name === 'compare' && refresh());
  return root;
}
