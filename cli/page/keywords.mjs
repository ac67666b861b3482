// The header of a profile, as keywords of LM-63. A EULUMDAT or TM-33 file shows the header that `convert` gives it.
import { card, el, fill, textOf } from './dom.mjs';
import { commands } from './app.mjs';

function keywordsOf(text) {
  const found = [];
  for (const line of text.split(/\r\n|\n|\r/)) {
    if (/^\s*TILT\s*=/i.test(line)) break;
    const match = /^\s*\[([^\]]*)\]\s?(.*)$/.exec(line);
    if (match && match[1].toUpperCase() === 'MORE' && found.length) found.at(-1)[1] += `\n${match[2]}`;
    else if (match) found.push([match[1], match[2]]);
    if (found.length > 500) break;
  }
  return found;
}

export function keywordsCard() {
  const body = el('div', {});
  const section = card('Header', body);
  section.show = async (file) => {
    section.file = file;
    if (file?.state === 'reading') return fill(body, el('p', { class: 'muted pad' }, 'Reading…'));
    let text = file?.text ?? '';
    if (file?.info && file.info.format !== 'IES') {
      try {
        file.asIes ??= textOf((await commands.run(['convert', file.path, '--to', 'ies', '-o', '-'], { [file.path]: file.bytes })).stdout);
        text = file.asIes;
      } catch {
        text = '';
      }
    }
    if (section.file !== file) return undefined;
    const found = keywordsOf(text);
    if (found.length === 0) return fill(body, el('p', { class: 'muted pad' }, 'The file has no keywords.'));
    return fill(body, el('dl', { class: 'keywords' }, ...found.flatMap(([key, value]) =>
      [el('dt', {}, key), el('dd', {}, value.trim() || el('span', { class: 'muted' }, 'empty'))])));
  };
  return section;
}
