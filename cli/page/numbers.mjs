// Numbers as text. Exact ones have all the digits of `gonio info --json`; a number is rounded only where the reader chose so
// or chose another unit.
import { el } from './dom.mjs';

// Four digits that count, without an exponent where one can do without.
export function briefNumber(value, digits = 4) {
  if (!Number.isFinite(value)) return String(value);
  if (value === 0) return '0';
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size > 9 || size < -6) return value.toExponential(digits - 1);
  const rounded = Number(value.toPrecision(digits));
  return size >= digits ? Math.round(value).toString() : String(rounded);
}

// All digits, those after the sixth that counts in a quieter tone.
export function exactNumber(value) {
  const text = String(value);
  const match = /^(-?[0.]*(?:\d\.?){1,6})(\d+)(e.*)?$/.exec(text);
  if (!match || !text.includes('.')) return el('span', { class: 'number' }, text);
  const whole = text.indexOf('.') + 1;
  const cut = Math.max(match[1].length, whole);
  if (text.length - cut < 3) return el('span', { class: 'number' }, text);
  return el('span', { class: 'number' }, text.slice(0, cut), el('span', { class: 'tail' }, text.slice(cut)));
}

export const lengthUnits = { m: 1, cm: 0.01, mm: 0.001, ft: 0.3048, in: 0.0254 };
export const fluxUnits = { lm: 1, klm: 1000 };
export const lx_per_fc = 10.763910416709722; // 1 / 0.3048²
