// What `gonio check` finds: each with the line of the file's own text, a caret under the column, and what the code means.
import { card, el, fill } from './dom.mjs';
import { commands, retry } from './app.mjs';
import { reportOf } from './engine.mjs';

const explained = new Map();

async function explain(code) {
  if (!explained.has(code)) explained.set(code, reportOf(await commands.run(['explain', code, '--json'])).codes?.[0]);
  return explained.get(code);
}

const shownWidth = 120;

// The line with the one before it, and a caret. Only a window around the column of a very long line.
function excerpt(file, { line, column }) {
  if (!line) return null;
  const lines = (file.lines ??= file.text.split(/\r\n|\n|\r/));
  const text = lines[line - 1];
  if (text === undefined) return null;
  const begin = Math.max(0, Math.min(column - 1 - shownWidth / 2, text.length - shownWidth));
  const shown = text.slice(begin, begin + shownWidth);
  const before = shown.slice(0, Math.max(0, column - 1 - begin)).replace(/[^\t]/g, ' ');
  const gutter = (number) => el('span', { class: 'gutter' }, `${String(number).padStart(String(line).length)} │ `);
  const visible = (part) => part.replace(/[\u0000-\u0008\u000b-\u001f\u007f]/g, '·');
  const rows = [];
  if (line > 1 && begin === 0) rows.push(gutter(line - 1), el('span', { class: 'quiet' }, visible(lines[line - 2].slice(0, shownWidth))), '\n');
  rows.push(gutter(line), `${begin ? '…' : ''}${visible(shown)}${begin + shownWidth < text.length ? '…' : ''}`, '\n');
  rows.push(el('span', { class: 'gutter' }, `${' '.repeat(String(line).length)} │ `), el('span', { class: 'caret' }, `${begin ? ' ' : ''}${before}^`));
  return el('pre', { class: 'excerpt', tabindex: 0, role: 'group', 'aria-label': `Line ${line} of the file, column ${column}` }, ...rows);
}

function item(file, entry) {
  const meaning = el('div', { class: 'meaning', hidden: true });
  const code = el('button', {
    type: 'button', class: 'code', 'aria-expanded': 'false', title: 'What this means',
    onclick: async () => {
      const open = code.getAttribute('aria-expanded') !== 'true';
      code.setAttribute('aria-expanded', open);
      meaning.hidden = !open;
      if (!open || meaning.childElementCount) return;
      try {
        const about = await explain(entry.code);
        fill(meaning, el('p', {}, el('strong', {}, about.title)), el('p', {}, about.explanation));
      } catch (error) {
        fill(meaning, el('p', {}, error.message));
      }
    },
  }, entry.code);
  return el('li', { class: `finding ${entry.severity}` },
    el('p', { class: 'finding-head' }, el('span', { class: `badge ${entry.severity}` }, entry.severity), code,
      entry.line ? el('span', { class: 'where' }, `${entry.line}:${entry.column}`) : null,
      el('span', { class: 'message' }, entry.message)),
    entry.hint ? el('p', { class: 'hint' }, `hint: ${entry.hint}`) : null, meaning, excerpt(file, entry));
}

export function findingsCard() {
  const body = el('div', {});
  const section = card('Check', body);
  section.classList.add('findings-card');
  section.show = (file) => {
    if (!file || file.state === 'reading') return fill(body, el('p', { class: 'muted pad' }, 'Checking…'));
    if (file.error)
      return fill(body, el('div', { class: 'problem pad', role: 'alert' }, el('p', {}, el('strong', {}, 'Not read: '), file.error.message),
        el('button', { type: 'button', onclick: () => retry(file) }, 'Try again')));
    const found = file.check.diagnostics;
    section.heading.textContent = found.length ? `Check: ${found.length} ${found.length === 1 ? 'finding' : 'findings'}` : 'Check';
    if (found.length === 0) return fill(body, el('p', { class: 'pad ok' }, 'Passed: no errors, warnings or notes.'));
    const order = { error: 0, warning: 1, note: 2 };
    const sorted = [...found].sort((a, b) => order[a.severity] - order[b.severity]);
    const first = sorted.slice(0, 50);
    const rest = sorted.slice(50);
    const list = el('ul', { class: 'findings' }, ...first.map((entry) => item(file, entry)));
    return fill(body, list, rest.length ? el('button', {
      type: 'button', class: 'pad', onclick: (event) => {
        list.append(...rest.map((entry) => item(file, entry)));
        event.target.remove();
      },
    }, `Show ${rest.length} more`) : null);
  };
  return section;
}
