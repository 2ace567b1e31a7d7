// What a person chooses of a diagnosis: a place of the gap, and how far from before to after.
import { el } from './kit.js';
import { percent, place } from './words-of-gap.js';

const LISTED = 200, PLACES = 12;
// Buttons for all and for each place; choose(-1) is all. They stand in a group of this id.
export function placeButtons(id, all, where, choose) {
  const press = index => { buttons.filter(button => button.hasAttribute('aria-pressed')).forEach((button, i) => button.setAttribute('aria-pressed', String(i - 1 === index))); choose(index); };
  const buttons = [all, ...where.map(one => place(one.slice) + ' \u00b7 ' + one.kind + ' \u00b7 ' + percent(one.share_of_gap))].map((name, i) =>
    el('button', { type: 'button', 'aria-pressed': String(i === 0), onclick: () => press(i - 1) }, name));
  const rest = buttons.slice(PLACES + 1);
  rest.forEach(button => { button.hidden = true; });
  if (rest.length) buttons.push(el('button', { type: 'button', class: 'more', onclick: event => { event.target.hidden = true; rest.forEach(button => { button.hidden = false; }); rest[0].focus(); } }, rest.length + ' more places'));
  return el('div', { class: 'bar places', id, role: 'group', 'aria-label': 'Places of the gap' }, buttons);
}
// From before (0) to after (1).
export function afterSlider(id, turn) {
  const slider = el('input', { type: 'range', min: 0, max: 100, value: 0, step: 1, id, class: 'after', 'aria-label': 'Before and after', 'aria-valuetext': 'before', oninput: () => {
    const t = Number(slider.value) / 100;
    slider.setAttribute('aria-valuetext', t === 0 ? 'before' : t === 1 ? 'after' : 'between');
    turn(t);
  } });
  return el('div', { class: 'bar' }, el('span', {}, 'before'), slider, el('span', {}, 'after'));
}
export const blend = (a, b, t) => a === null ? b : b === null ? a : a + (b - a) * t;
export const mean = list => list.length ? list.reduce((sum, v) => sum + v, 0) / list.length : null;
export function quantile(values, share) { const sorted = [...values].sort((a, b) => a - b); return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]; }
export const fewOf = list => list.slice(0, LISTED);
export const moreNote = (list, what) => list.length > LISTED ? el('p', { class: 'note' }, 'The first ' + LISTED + ' of ' + list.length + ' ' + what + '; the csv has all.') : null;
// The least circle's square round some places, as a sheet shows it.
export function around(sheet, places) {
  const low = [0, 1].map(k => places.reduce((m, p) => Math.min(m, p[k]), Infinity)), high = [0, 1].map(k => places.reduce((m, p) => Math.max(m, p[k]), -Infinity));
  sheet.shows([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2], 0.55 * Math.max(0.2, high[0] - low[0], high[1] - low[1]));
}
// Of two that are compared the one that is chosen; show(host, answer) returns what closes it.
export function oneOf(page, answers, label, show) {
  const host = el('div', { class: 'opened' });
  let close = () => {};
  const press = index => {
    close();
    host.replaceChildren();
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === index)));
    close = show(host, answers[index]);
  };
  const buttons = answers.map((one, i) => el('button', { type: 'button', onclick: () => press(i) }, one.path));
  page.append(...(answers.length > 1 ? [el('div', { class: 'bar oneof', role: 'group', 'aria-label': label }, el('span', {}, label), buttons)] : []), host);
  press(0);
  return () => close();
}
