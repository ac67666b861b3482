// Elements. Texts are only ever set as text, never parsed as HTML: names and texts of files come from others.

// el('button', { class: 'small', type: 'button', onclick: f, 'aria-label': 'Save' }, 'Save', …)
export function el(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (key === 'value' || key === 'checked' || key === 'disabled' || key === 'selected') element[key] = value;
    else element.setAttribute(key, value === true ? '' : String(value));
  }
  element.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

export const byId = (id) => document.getElementById(id);

export function fill(element, ...children) {
  element.replaceChildren(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

// One of several values: buttons of a radio group, moved through by the arrow keys.
export function segmented(label, entries, value, choose) {
  const group = el('div', { class: 'segmented', role: 'radiogroup', 'aria-label': label });
  const buttons = entries.map(([key, text, title]) => el('button', {
    type: 'button', role: 'radio', 'data-value': key, title, onclick: () => pick(key, true),
  }, text));
  function pick(key, tell) {
    for (const button of buttons) {
      const on = button.dataset.value === String(key);
      button.setAttribute('aria-checked', on);
      button.tabIndex = on ? 0 : -1;
    }
    if (tell) choose(key);
  }
  group.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    const next = buttons[(buttons.indexOf(event.target) + step + buttons.length) % buttons.length];
    next.focus();
    pick(next.dataset.value, true);
    event.preventDefault();
    event.stopPropagation();
  });
  group.append(...buttons);
  group.set = (key) => pick(key, false);
  group.set(value);
  return group;
}

export function select(label, entries, value, choose, properties = {}) {
  const element = el('select', { 'aria-label': label, onchange: () => choose(element.value), ...properties });
  let held = '';
  element.setEntries = (list, chosen) => {
    const wanted = JSON.stringify(list);
    if (wanted !== held) fill(element, ...list.map(([key, text]) => el('option', { value: key }, text)));
    held = wanted;
    if (element.value !== chosen) element.value = chosen;
  };
  element.setEntries(entries, value);
  return element;
}

// A labelled line of a form.
let fieldNumber = 0;
export function field(label, control, note) {
  if (!control.id) control.id = `field-${++fieldNumber}`;
  control.removeAttribute('aria-label');
  return el('div', { class: 'field' }, el('label', { for: control.id }, label), control, note ?? null);
}

export function card(title, ...children) {
  const heading = el('h3', {}, title);
  const head = el('div', { class: 'card-head' }, heading);
  const section = el('section', { class: 'card', 'aria-label': title }, head, ...children);
  section.head = head;
  section.heading = heading;
  return section;
}

// The tool's own sentences, for what went wrong.
export function problem(error) {
  const list = error.diagnostics?.length ? error.diagnostics : [{ severity: 'error', code: error.code, message: error.message, hint: error.hint }];
  return el('div', { class: 'problem', role: 'alert' }, ...list.map((entry) => el('p', { class: entry.severity },
    el('strong', {}, entry.code ? `${entry.severity}[${entry.code}]: ` : `${entry.severity}: `), entry.message,
    entry.hint ? el('span', { class: 'hint' }, `hint: ${entry.hint}`) : null)));
}

export function download(name, bytes, type = 'application/octet-stream') {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const link = el('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

// A picture of the tool's SVG: as an image, no script in it runs and nothing is loaded.
export function showSvg(image, svg, alt) {
  if (image.src) URL.revokeObjectURL(image.src);
  image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  image.alt = alt;
}

export const textOf = (bytes) => new TextDecoder().decode(bytes);

// At most as often as `wait` allows, the last call included.
export function debounce(wait, call) {
  let timer;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => call(...values), wait);
  };
}
