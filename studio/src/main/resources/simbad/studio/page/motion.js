// A diagnosis of motion: its answer, how well forecasts are before and after, where it lies.
import { csvText, el, giveText, number, table } from './kit.js';
import { bar, effects, percent, place, verdict } from './words-of-gap.js';

const PARTS = [['along_m', 'along', 1000, ' mm'], ['across_m', 'across', 1000, ' mm'], ['turn_rad', 'turn', 180 / Math.PI, '\u00b0']];

export function showMotion(page, answer, other) {
  const both = [answer, other].filter(Boolean);
  page.append(el('div', { class: other ? 'twin' : 'opened' }, both.map(one => el('div', {}, other ? el('h3', {}, one.path) : null, verdict(one.diagnosis), gap(one.diagnosis, both)))),
    effects(answer.diagnosis, other && other.diagnosis), places(answer.diagnosis));
}
function gap(diagnosis, both) {
  const horizons = (diagnosis.gap || {}).horizons || [];
  const section = el('section', {}, el('h3', {}, 'How far forecasts are off, before and after'));
  for (const horizon of horizons) {
    section.append(el('h4', {}, 'over ' + horizon.horizon_s + ' s'), el('div', { class: 'bars' }, PARTS.flatMap(([key, name, times, unit]) => {
      const most = Math.max(...both.flatMap(one => ((one.diagnosis.gap || {}).horizons || []).filter(h => h.horizon_s === horizon.horizon_s).flatMap(h => [h[key].before, h[key].after])));
      return [...bar(name + ', before', horizon[key].before / most, number(times * horizon[key].before, 2) + unit, 'before'), ...bar(name + ', after', horizon[key].after / most, number(times * horizon[key].after, 2) + unit, 'after')];
    })));
  }
  const csv = () => csvText(['horizon_s', 'component', 'before', 'after'], horizons.flatMap(h => PARTS.map(([key]) => [h.horizon_s, key, h[key].before, h[key].after])));
  const shrink = (diagnosis.gap || {}).shrink_ci95 || [null, null];
  section.append(el('p', { class: 'note' }, 'In total it shrinks by ' + percent((diagnosis.gap || {}).shrink) + ' (95 % interval ' + percent(shrink[0]) + ' to ' + percent(shrink[1]) + ').'),
    el('div', { class: 'bar' }, el('button', { type: 'button', onclick: () => giveText('forecasts.csv', csv(), 'text/csv') }, 'Save csv')));
  return section;
}
function places(diagnosis) {
  return el('section', {}, el('h3', {}, 'Where the gap lies'), table('Where the gap lies', ['place', '#windows', '#share of the gap', '#before', '#after'],
    (diagnosis.where || []).map(one => [place(one.slice), String(one.rows), percent(one.share_of_gap), number(one.before, 2), number(one.after, 2)])));
}
