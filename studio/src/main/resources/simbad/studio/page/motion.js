// A diagnosis of motion: its answer, how well forecasts are before and after, where it lies.
import { csvText, el, number, table } from './kit.js';
import { chart, dash } from './charts.js';
import { afterSlider, around, blend, fewOf, mean, moreNote, oneOf, placeButtons, quantile } from './places.js';
import { line, Sheet } from './sheet.js';
import { bar, budget, effects, percent, place, saveBars, verdict } from './words-of-gap.js';

const PARTS = [['along_m', 'along', 1000, ' mm'], ['across_m', 'across', 1000, ' mm'], ['turn_rad', 'turn', 180 / Math.PI, '\u00b0']];

export function showMotion(page, answer, other) {
  page.append(el('div', { class: other ? 'twin' : 'opened' }, [answer, other].filter(Boolean).map(one => el('div', {}, other ? el('h3', {}, one.path) : null, verdict(one.diagnosis)))));
  page.append(effects(answer.diagnosis, other && other.diagnosis));
  return motionParts(page, [answer, other].filter(Boolean), one => one.diagnosis);
}
// What the motion's half of each diagnosis has: forecasts and parts of the gap beside each other, and the drive of one with its places.
export function motionParts(page, answers, motionOf) {
  const both = answers.map(motionOf).filter(Boolean);
  page.append(el('div', { class: both.length > 1 ? 'twin' : 'opened' }, both.map(one => el('div', {}, gap(one, both), budget(one.budget || [])))));
  return oneOf(page, answers, 'The drive of', (host, one) => driveOf(host, one, motionOf(one) || {}));
}
function driveOf(host, answer, diagnosis) {
  const closing = [];
  if (answer.windows && answer.windows.length) drive(host, answer, diagnosis, closing);
  else {
    if ((diagnosis.where || []).length) host.append(places(diagnosis));
    if (answer.missing) host.append(el('section', {}, el('h3', {}, 'The drive'), el('p', { class: 'missing' }, 'The drive is not shown: ' + answer.missing + '.')));
  }
  return () => closing.forEach(close => close());
}
function gap(diagnosis, both) {
  const horizons = (diagnosis.gap || {}).horizons || [];
  const section = el('section', {}, el('h3', {}, 'How far forecasts are off, before and after'));
  for (const horizon of horizons) {
    section.append(el('h4', {}, 'over ' + horizon.horizon_s + ' s'), el('div', { class: 'bars' }, PARTS.flatMap(([key, name, times, unit]) => {
      const most = Math.max(...both.flatMap(one => ((one.gap || {}).horizons || []).filter(h => h.horizon_s === horizon.horizon_s).flatMap(h => [h[key].before, h[key].after])));
      return [...bar(name + ', before', horizon[key].before / most, number(times * horizon[key].before, 2) + unit, 'before'), ...bar(name + ', after', horizon[key].after / most, number(times * horizon[key].after, 2) + unit, 'after')];
    })));
  }
  const shrink = (diagnosis.gap || {}).shrink_ci95 || [null, null];
  section.append(el('p', { class: 'note' }, 'In total it shrinks by ' + percent((diagnosis.gap || {}).shrink) + ' (95 % interval ' + percent(shrink[0]) + ' to ' + percent(shrink[1]) + ').'),
    saveBars('forecasts', 'How far forecasts are off, before and after', () => horizons.flatMap(h => PARTS.flatMap(([key, name, times, unit]) => ['before', 'after'].map(when => ({ name: name + ', ' + h.horizon_s + ' s, ' + when, colour: when === 'before' ? 'c1' : 'c0',
      share: h[key][when] / Math.max(h[key].before, h[key].after), text: number(times * h[key][when], 2) + unit })))), ['horizon_s', 'component', 'before', 'after'], horizons.flatMap(h => PARTS.map(([key]) => [h.horizon_s, key, h[key].before, h[key].after]))));
  return section;
}
function places(diagnosis) {
  return el('section', {}, el('h3', {}, 'Where the gap lies'), table('Where the gap lies', ['place', '#windows', '#share of the gap', '#before', '#after'],
    (diagnosis.where || []).map(one => [place(one.slice), String(one.rows), percent(one.share_of_gap), number(one.before, 2), number(one.after, 2)])));
}
// What was seen less what was expected over half a second, of each component: its columns, unit, and words for either side.
const ERRORS = [{ name: 'along', unit: 'mm', times: 1000, before: 'along_before_m', after: 'along_after_m', less: 'less far than expected', more: 'farther than expected' },
  { name: 'across', unit: 'mm', times: 1000, before: 'across_before_m', after: 'across_after_m', less: 'to the right of it', more: 'to the left of it' },
  { name: 'turn', unit: '\u00b0', times: 180 / Math.PI, before: 'turn_before_rad', after: 'turn_after_rad', less: 'turned less to the left', more: 'turned more to the left' }];
const LONGER = 10, MOST_LINES = 600;
function drive(page, answer, diagnosis, closing) {
  const column = Object.fromEntries(answer.window_columns.map((name, i) => [name, i])), all = answer.windows, where = diagnosis.where || [];
  let chosen = -1, t = 0, error = ERRORS[0];
  const off = (row, one = error, at = t) => one.times * blend(row[column[one.before]], row[column[one.after]], at);
  const mine = () => chosen < 0 ? all : answer.window_places[chosen].map(i => all[i]);
  const plan = new Sheet('The drive, seen from above', 'drive', (g, v, colours) => paint(g, v, colours));
  const paint = (g, v, colours) => {
    const u = v.unit, marked = new Set(mine()), most = Math.max(1e-9, quantile(all.map(row => Math.abs(off(row, error, 0))), 0.95));
    g.strokeStyle = colours.quiet; g.lineWidth = 1.5 * u;
    for (const track of answer.tracks) for (const piece of track.pieces) { line(g, v, piece); g.stroke(); }
    for (const row of [...all.filter(row => !marked.has(row)), ...marked]) {
      const x = v.x(row[column.x_m]), y = v.y(row[column.z_m]), size = (1.2 + 5 * Math.sqrt(Math.min(1, Math.abs(off(row)) / most))) * u;
      g.globalAlpha = marked.has(row) ? 0.85 : 0.15;
      g.fillStyle = off(row) < 0 ? colours.low : colours.high;
      g.beginPath(); g.arc(x, y, size, 0, 2 * Math.PI); g.fill();
      if (marked.has(row) && marked.size <= MOST_LINES) whisker(g, v, colours, row);
    }
    g.globalAlpha = 1;
  };
  // From where the robot came to, to where it was expected: ten times as long, lest nobody sees it.
  const whisker = (g, v, colours, row) => {
    const cos = Math.cos(row[column.heading_rad]), sin = Math.sin(row[column.heading_rad]), at = (along, across) => [along * cos - across * sin, -(along * sin + across * cos)];
    const [ex, ez] = at(row[column.along_m], row[column.across_m]), [dx, dz] = at(-LONGER * off(row, ERRORS[0]) / 1000, -LONGER * off(row, ERRORS[1]) / 1000);
    const x = row[column.x_m] + ex, z = row[column.z_m] + ez;
    g.strokeStyle = colours.ink; g.lineWidth = v.unit;
    g.beginPath(); g.moveTo(v.x(x), v.y(z)); g.lineTo(v.x(x + dx), v.y(z + dz)); g.stroke();
  };
  const order = all.map((row, i) => i).sort((a, b) => all[a][column.t_s] - all[b][column.t_s]);
  const values = () => { const marked = chosen < 0 ? null : new Set(mine()); return [order.map(i => marked && marked.has(all[i]) ? null : off(all[i])), order.map(i => marked && marked.has(all[i]) ? off(all[i]) : null), order.map(() => 0)]; };
  const host = el('div');
  let made = null;
  closing.push(() => made && made.close());
  const plot = () => {
    if (made) made.close();
    const first = values();
    made = chart({ name: 'motion-error', label: 'Seen less expected over half a second, ' + error.name + ', ' + error.unit, x: order.map(i => all[i][column.t_s]), xLabel: 'time, s', yLabel: error.unit, height: 280,
      series: [{ name: 'seen less expected', values: first[0], colour: 'c0', points: true }, { name: 'the same, of the chosen place', values: first[1], colour: 'c1', points: true }, { name: 'as expected', values: first[2], colour: 'quiet', dash: dash(1), width: 1 }] });
    host.replaceChildren(made.element);
  };
  const said = el('p', { class: 'note', role: 'status', id: 'drivesaid' }), list = el('div'), tip = el('p', { class: 'note said', id: 'drivetip' }, '\u00a0');
  const low = el('span'), high = el('span');
  const say = () => {
    const size = at => number(mean(mine().map(row => Math.abs(off(row, error, at)))), 2);
    said.textContent = (chosen < 0 ? 'All' : place(where[chosen].slice) + ':') + ' ' + mine().length + ' windows of half a second; ' + error.name + ', the mean error is ' + size(0) + ' ' + error.unit + ' before, ' + size(1) + ' ' + error.unit + ' after'
      + (answer.windows_every > 1 ? '. Every ' + answer.windows_every + 'th of ' + answer.all_windows + ' windows is shown' : '') + '.';
    low.textContent = error.less;
    high.textContent = error.more;
  };
  const turn = to => { t = to; if (made) made.update(values()); say(); plan.draw(); };
  const component = name => { error = ERRORS.find(one => one.name === name) || error; select.value = error.name; plot(); say(); plan.draw(); };
  const select = el('select', { onchange: () => component(select.value) }, ERRORS.map(one => el('option', { value: one.name }, one.name)));
  const choose = index => {
    chosen = index;
    list.replaceChildren(index < 0 ? '' : table('Windows of the place', ['run', '#time, s', ...ERRORS.flatMap(one => ['#' + one.name + ' before, ' + one.unit, '#after'])],
      fewOf(mine()).map(row => [row[column.run], number(row[column.t_s], 1), ...ERRORS.flatMap(one => [number(off(row, one, 0), 2), number(off(row, one, 1), 2)])])), index >= 0 && moreNote(mine(), 'windows') || '');
    component(index < 0 ? error.name : where[index].kind);
  };
  plan.onpoint = (point, v) => {
    const far = row => Math.hypot(row[column.x_m] - point[0], row[column.z_m] - point[1]);
    const near = mine().reduce((best, row) => !best || far(row) < far(best) ? row : best, null);
    tip.textContent = near && far(near) * v.scale < 15 ? 'Run ' + near[column.run] + ', ' + number(near[column.t_s], 1) + ' s: ' + ERRORS.map(one => one.name + ' ' + number(off(near, one, 0), 2) + ' ' + one.unit + ' before and ' + number(off(near, one, 1), 2) + ' after').join(', ') : '\u00a0';
  };
  plan.element.append(tip, el('ul', { class: 'legend' }, el('li', {}, el('i', { class: 'key-quiet' }), 'track'), el('li', {}, el('i', { class: 'dot key-low' }), low), el('li', {}, el('i', { class: 'dot key-high' }), high),
    el('li', {}, 'size: how far off'), el('li', {}, el('i', { class: 'key-ink' }), 'from where it came to, to where it was expected, ten times as long')), plan.buttons(() => csvText(answer.window_columns, mine())));
  page.append(el('section', {}, el('h3', {}, 'Where the gap of the motion lies'), placeButtons('driveplaces', 'All windows', where, choose), afterSlider('driveafter', turn), el('label', { class: 'search' }, 'Component', select), said),
    el('div', { class: 'twin' }, el('section', {}, plan.element), el('div', {}, el('section', {}, host), list)));
  around(plan, answer.tracks.flatMap(track => track.pieces.flat()));
  component('along');
}
