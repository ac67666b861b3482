// The tool's diagrams, as images of its SVG, and the solid that turns.
import { card, download, el, problem, segmented, showSvg, textOf, debounce } from './dom.mjs';
import { commands } from './app.mjs';
import { succeeded } from './engine.mjs';
import { solidView } from './solid.mjs';

const diagramKinds = [
  ['polar', 'Polar'], ['cartesian', 'Cartesian'], ['heat-map', 'Heat map'], ['isolux', 'Isolux'], ['cone', 'Cone'],
];
export const describe = { polar: 'Polar diagram', cartesian: 'Cartesian diagram', 'heat-map': 'Heat map', isolux: 'Isolux diagram', cone: 'Cone diagram' };

// SVG text of a diagram of one or more profiles.
export async function drawDiagram(files, kind, { perKlm = false, height = '' } = {}) {
  const words = ['plot', ...files.map((file) => file.path), '--diagram', kind, '-s', '720x720', '-o', '-'];
  if (perKlm && kind !== 'isolux' && kind !== 'cone') words.push('--per-klm');
  if (height && (kind === 'isolux' || kind === 'cone')) words.push('--height', height);
  const answer = succeeded(await commands.run(words, Object.fromEntries(files.map((file) => [file.path, file.bytes])), { label: 'drawing' }));
  return textOf(answer.stdout);
}

export function diagramCard() {
  const image = el('img', { class: 'diagram', alt: '', width: 720, height: 720 });
  const solid = solidView();
  const frame = el('div', { class: 'diagram-frame' }, image, solid);
  const state = { kind: 'polar', perKlm: false, height: '3m' };
  let current;
  let svg = '';

  const perKlm = el('input', { type: 'checkbox', onchange: () => { state.perKlm = perKlm.checked; draw(); } });
  const perKlmField = el('label', { class: 'check' }, perKlm, ' per 1000 lm');
  const height = el('input', { type: 'text', value: state.height, size: 6, oninput: debounce(300, () => { state.height = height.value.trim(); draw(); }) });
  const heightField = el('label', { class: 'check' }, 'Height ', height);
  const save = el('button', { type: 'button', class: 'small', onclick: () => current && download(`${current.path}-${state.kind}.svg`, svg, 'image/svg+xml') }, 'Save SVG');
  const kinds = segmented('Diagram', [...diagramKinds, ['solid', 'Solid', 'The photometric solid: turn it by dragging or with the arrow keys']], state.kind, (kind) => {
    state.kind = kind;
    draw();
  });
  const section = card('Diagram', kinds, frame, el('div', { class: 'card-foot' }, perKlmField, heightField, el('span', { class: 'spring' }), save));
  section.classList.add('diagram-card');

  async function draw() {
    const file = current;
    const isSolid = state.kind === 'solid';
    perKlmField.hidden = !['polar', 'cartesian', 'heat-map'].includes(state.kind);
    heightField.hidden = !['isolux', 'cone'].includes(state.kind);
    save.hidden = isSolid;
    solid.hidden = !isSolid;
    frame.querySelector('.problem')?.remove();
    image.hidden = isSolid || !file?.info;
    image.classList.toggle('invertible', state.kind !== 'heat-map');
    section.dataset.ready = '';
    if (!file?.info) {
      solid.show(undefined);
      solid.hidden = true;
      frame.dataset.empty = file?.state === 'reading' ? 'Reading…' : 'No diagram: the file cannot be read.';
      return;
    }
    frame.dataset.empty = '';
    try {
      if (isSolid) {
        await solid.show(file);
      } else {
        const drawn = await drawDiagram([file], state.kind, state);
        if (current !== file || state.kind === 'solid') return;
        svg = drawn;
        showSvg(image, svg, `${describe[state.kind]} of ${file.name}`);
      }
      section.dataset.ready = `${file.id} ${state.kind}`;
    } catch (error) {
      if (current !== file) return;
      image.hidden = true;
      frame.append(problem(error));
    }
  }
  section.show = (file) => {
    current = file;
    return draw();
  };
  section.choose = (kind) => {
    kinds.set(kind);
    state.kind = kind;
    return draw();
  };
  return section;
}
