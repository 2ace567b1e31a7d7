// A diagnosis of sensing: its answer, its places in the plan, its curves over the believed ones.
import { csvText, el, number, table } from './kit.js';
import { chart, dash } from './charts.js';
import { line, Sheet } from './sheet.js';
import { afterSlider, around, blend, fewOf, mean, moreNote, oneOf, placeButtons, quantile } from './places.js';
import { budget, effects, gapBars, place, verdict } from './words-of-gap.js';

export function showSensing(page, answer, other) {
  const diagnosis = answer.diagnosis, closing = [];
  if (other) {
    const most = Math.max(...[diagnosis, other.diagnosis].map(one => one.gap ? Math.max(one.gap.before_cm, one.gap.after_cm) : 0));
    page.append(el('div', { class: 'twin' }, [answer, other].map(one => el('div', {}, el('h3', {}, one.path), verdict(one.diagnosis), one.diagnosis.gap ? gapBars(one.diagnosis.gap, most) : null, budget(one.diagnosis.budget || [])))));
  } else {
    page.append(el('div', { class: 'twin' }, el('div', {}, verdict(diagnosis), diagnosis.gap ? gapBars(diagnosis.gap) : null), el('div', {}, budget(diagnosis.budget || []))));
  }
  if (diagnosis.verdict) page.append(effects(diagnosis, other && other.diagnosis));
  if (answer.obstacles) curves(page, answer, other, closing);
  closing.push(oneOf(page, [answer, other].filter(Boolean), 'The rows of', rowsOf));
  return () => closing.forEach(close => close());
}
function rowsOf(host, answer) {
  const closing = [];
  if (answer.rows) rows(host, answer, closing);
  else if (answer.missing) host.append(el('section', {}, el('h3', {}, 'Rows'), el('p', { id: 'missing' }, 'The rows are not shown: ' + answer.missing + '.')));
  return () => closing.forEach(close => close());
}
function curves(page, answer, other, closing) {
  for (const obstacle of answer.obstacles) {
    const n = obstacle.believed_m.length, same = other && other.obstacles && other.obstacles.find(one => one.name === obstacle.name);
    const heard = values => values.map(v => v > 0 ? v : null);
    const made = chart({ name: 'thresholds-' + obstacle.name, label: 'How far ' + obstacle.name + ' is heard on the axis, by bearing', x: obstacle.believed_m.map((v, i) => 360 * i / n), xLabel: 'bearing, degrees', yLabel: 'm', every: 30, height: 260, from0: true,
      series: [{ name: 'fitted', values: heard(obstacle.fitted_m), colour: 'c1', width: 3 }, { name: 'believed', values: heard(obstacle.believed_m), colour: 'ink', dash: dash(1) },
        ...(same ? [{ name: 'fitted \u00b7 ' + other.path, values: heard(same.fitted_m), colour: 'c2', dash: dash(3) }] : [])] });
    closing.push(() => made.close());
    page.append(el('section', {}, made.element));
  }
}
function rows(page, answer, closing) {
  const column = Object.fromEntries(answer.columns.map((name, i) => [name, i])), all = answer.rows;
  const gapOf = (row, t) => blend(row[column.gap_before_cm], row[column.gap_after_cm], t);
  const residual = (row, t) => row[column.residual_before_cm] === null && row[column.residual_after_cm] === null ? null : blend(row[column.residual_before_cm], row[column.residual_after_cm], t);
  let chosen = -1, t = 0;
  const most = quantile(all.map(row => row[column.gap_before_cm]), 0.95) || 1;
  const mine = () => chosen < 0 ? all : answer.places[chosen].map(i => all[i]);
  const plan = new Sheet('Rows of the data set, seen from above', 'rows', (g, v, colours) => paint(g, v, colours));
  const paint = (g, v, colours) => {
    const u = v.unit, marked = new Set(chosen < 0 ? [] : answer.places[chosen]);
    for (const obstacle of answer.obstacles) {
      g.fillStyle = colours.body; g.strokeStyle = colours.body; g.lineWidth = 2 * u;
      line(g, v, obstacle.outline, true); g.fill(); g.stroke();
    }
    const draw = (row, faded) => {
      const x = v.x(row[column.x_m]), y = v.y(row[column.z_m]), size = (1.6 + 5 * Math.sqrt(Math.min(1, gapOf(row, t) / most))) * u, late = residual(row, t);
      // Short ranges one colour, long ones another; no echo read is a ring.
      g.globalAlpha = faded ? 0.18 : 0.85;
      g.beginPath(); g.arc(x, y, size, 0, 2 * Math.PI);
      const tint = row[column.range_m] === null ? colours.soft : late === null ? colours.c3 : late < 0 ? colours.low : colours.high;
      if (row[column.range_m] === null) { g.strokeStyle = tint; g.lineWidth = 1.5 * u; g.stroke(); } else { g.fillStyle = tint; g.fill(); }
      if (!faded && chosen >= 0) {
        g.strokeStyle = tint; g.lineWidth = u; g.beginPath(); g.moveTo(x, y);
        g.lineTo(x + 3 * size * Math.cos(row[column.heading_rad]), y - 3 * size * Math.sin(row[column.heading_rad])); g.stroke();
      }
      g.globalAlpha = 1;
    };
    all.forEach((row, i) => { if (chosen >= 0 && !marked.has(i)) draw(row, true); });
    all.forEach((row, i) => { if (chosen < 0 || marked.has(i)) draw(row, false); });
  };
  // Residuals against distance, and what the fit moves ranges by.
  const order = all.map((row, i) => i).filter(i => all[i][column.distance_m] !== null && residual(all[i], 0) !== null).sort((a, b) => all[a][column.distance_m] - all[b][column.distance_m]);
  const values = () => { const set = chosen < 0 ? null : new Set(answer.places[chosen]); return [order.map(i => set && set.has(i) ? null : residual(all[i], t)), order.map(i => set && set.has(i) ? residual(all[i], t) : null), order.map(i => shift(all[i])), order.map(() => 0)]; };
  const shift = row => row[column.residual_before_cm] === null || row[column.residual_after_cm] === null ? null : row[column.residual_before_cm] - row[column.residual_after_cm];
  const first = values();
  const range = order.length ? chart({ name: 'range-error', label: 'Range error by distance, cm', x: order.map(i => all[i][column.distance_m]), xLabel: 'distance to the nearest obstacle\u2019s centre, m', yLabel: 'cm', height: 280,
    series: [{ name: 'reading less the expected range', values: first[0], colour: 'c0', points: true }, { name: 'the same, of the chosen place', values: first[1], colour: 'c1', points: true },
      { name: 'what the fit moves ranges by', values: first[2], colour: 'c2', points: true, ring: true }, { name: 'as believed', values: first[3], colour: 'quiet', dash: dash(1), width: 1 }] }) : null;
  if (range) closing.push(() => range.close());
  const said = el('p', { class: 'note', role: 'status', id: 'rowsaid' }), list = el('div');
  const turn = to => { t = to; if (range) range.update(values()); say(); plan.draw(); };
  const say = () => {
    const shown = mine(), where = chosen < 0 ? 'All' : place(answer.diagnosis.where[chosen].slice) + ':';
    said.textContent = where + ' ' + shown.length + ' rows; mean gap ' + number(mean(shown.map(r => r[column.gap_before_cm])), 2) + ' cm before, ' + number(mean(shown.map(r => r[column.gap_after_cm])), 2) + ' cm after, with the model that was fitted to all rows'
      + (answer.every > 1 ? '. Every ' + answer.every + 'th of ' + answer.all_rows + ' rows is shown' : '') + '.';
  };
  const choose = index => {
    chosen = index;
    list.replaceChildren(index < 0 ? '' : table('Rows of the place', ['#row', '#range, m', '#gap before, cm', '#after', '#residual before, cm', '#after'],
      fewOf(mine()).map(row => [row[column.row], row[column.range_m] === null ? 'no echo' : number(row[column.range_m], 3), number(row[column.gap_before_cm], 2), number(row[column.gap_after_cm], 2), number(row[column.residual_before_cm], 2), number(row[column.residual_after_cm], 2)])),
    index >= 0 && moreNote(mine(), 'rows') || '');
    turn(t);
  };
  const tip = el('p', { class: 'note said', id: 'rowtip' }, '\u00a0');
  plan.onpoint = (point, v) => {
    const far = row => Math.hypot(row[column.x_m] - point[0], row[column.z_m] - point[1]);
    const near = mine().reduce((best, row) => far(row) < far(best) ? row : best, mine()[0]);
    tip.textContent = near && far(near) * v.scale < 15 ? 'Row ' + near[column.row] + ': ' + (near[column.range_m] === null ? 'no echo' : 'range ' + number(near[column.range_m], 3) + ' m') + ', bearing ' + number(near[column.bearing_deg], 0)
      + '\u00b0, distance ' + number(near[column.distance_m], 2) + ' m, off the axis ' + number(near[column.off_axis_deg], 0) + '\u00b0, gap ' + number(near[column.gap_before_cm], 2) + ' cm before and ' + number(near[column.gap_after_cm], 2) + ' after' : '\u00a0';
  };
  plan.element.append(tip, el('ul', { class: 'legend' }, el('li', {}, el('i', { class: 'dot key-low' }), 'range too short'), el('li', {}, el('i', { class: 'dot key-high' }), 'range too long'), el('li', {}, el('i', { class: 'dot key-c3' }), 'echo where none was expected'),
    el('li', {}, el('i', { class: 'ringkey' }), 'no echo'), el('li', {}, 'size: the row\u2019s gap')), plan.buttons(() => csvText(answer.columns, mine())));
  page.append(el('section', {}, el('h3', {}, 'Where the gap lies'), placeButtons('places', 'All rows', answer.diagnosis.where || [], choose), afterSlider('after', turn), said),
  el('div', { class: 'twin' }, el('section', {}, plan.element), el('div', {}, range ? el('section', {}, range.element) : null, list)));
  // Where the rows are, and their obstacles.
  around(plan, [...all.map(row => [row[column.x_m], row[column.z_m]]), ...answer.obstacles.flatMap(one => one.outline)]);
  say();
}
