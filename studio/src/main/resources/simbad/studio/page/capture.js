// A capture: what came of each bearing until now, and of how many pings.
import { csvText, el, lineKey, number, table } from './kit.js';
import { chart, dash } from './charts.js';
import { atBearing, bearingLine, line, Sheet } from './sheet.js';

export function showCapture(page, answer, other) {
  const all = answer.bearings, degrees = all.map(one => one.bearing_deg);
  const same = one => other && other.bearings.find(b => Math.abs(b.bearing_deg - one.bearing_deg) < 1e-6);
  const values = (key, of = one => one) => all.map(one => of(one)?.[key] ?? null);
  let at = Math.max(0, all.findIndex(one => one.threshold_m !== undefined));
  const plan = new Sheet('Thresholds of ' + answer.obstacle + ' by bearing, seen from above', 'thresholds', (g, v, colours) => paint(g, v, colours, answer.edge, all, other ? other.bearings : [], at));
  const made = chart({ name: 'thresholds', label: 'Threshold by bearing, m', x: degrees, xLabel: 'bearing, degrees', yLabel: 'm', every: 30, height: 260, from0: true, onhover: index => choose(index),
    series: [{ name: 'captured', values: values('threshold_m'), colour: 'c1', width: 3 }, { name: 'interval, low', values: values('low_m'), colour: 'quiet', dash: dash(1), width: 1 }, { name: 'interval, high', values: values('high_m'), colour: 'quiet', dash: dash(1), width: 1 },
      ...(all.some(one => one.table_m !== undefined) ? [{ name: 'table of the catalogue', values: values('table_m'), colour: 'ink', dash: dash(1) }] : []),
      ...(other ? [{ name: 'captured \u00b7 ' + other.path, values: values('threshold_m', same), colour: 'c2', dash: dash(3), width: 3 }] : [])] });
  const slider = el('input', { type: 'range', min: 0, max: all.length - 1, step: 1, value: at, 'aria-label': 'Bearing', oninput: () => choose(Number(slider.value)) });
  const heading = el('h3', {}, ' '), readout = el('tbody'), list = el('div');
  const metres = value => value === undefined || value === null ? '\u2013' : number(value, 3) + ' m';
  const said = one => one.threshold_m === undefined ? 'not measured yet' : metres(one.threshold_m);
  const choose = index => {
    at = index;
    const one = all[at], twin = same(one);
    slider.value = index;
    slider.setAttribute('aria-valuetext', degrees[index] + ' degrees');
    heading.textContent = 'At bearing ' + degrees[index] + '\u00b0';
    readout.replaceChildren(...[['threshold', said(one)], ['95 % interval', one.low_m === undefined ? '\u2013' : number(one.low_m, 3) + ' to ' + number(one.high_m, 3) + ' m'], ['pings', one.heard + ' of ' + one.pings + ' heard'],
      ...(one.table_m === undefined ? [] : [['table of the catalogue', metres(one.table_m)]]), ...(other ? [[other.path, twin ? said(twin) : '\u2013']] : [])]
      .map(([what, value]) => el('tr', {}, el('th', { scope: 'row' }, what), el('td', { class: 'r' }, value))));
    list.replaceChildren(table('Distances tried', ['#distance, m', '#pings', '#heard', 'the echo is'], one.levels.map(([m, pings, heard, lost]) => [number(m, 3), String(pings), String(heard), lost ? 'lost' : pings < answer.pings_each ? 'not finished' : 'heard'])));
    made.at(index);
    plan.draw();
  };
  plan.onpoint = ([x, z]) => choose(Math.round((Math.atan2(x, z) * 180 / Math.PI + 360) % 360 / 360 * all.length) % all.length);
  plan.onkey = key => { const by = { ArrowLeft: -1, ArrowRight: 1 }[key]; if (by) choose((at + by + all.length) % all.length); return Boolean(by); };
  const heads = ['bearing_deg', 'threshold_m', 'low_m', 'high_m', 'pings', 'heard', 'table_m'];
  plan.element.append(el('ul', { class: 'legend' }, el('li', {}, lineKey('c1'), 'captured, with its interval'), el('li', {}, lineKey('edge'), 'table of the catalogue'), other ? el('li', {}, lineKey('c2', dash(1)), other.path) : null,
    el('li', {}, el('i', { class: 'dot key-c0' }), 'heard at this distance'), el('li', {}, el('i', { class: 'ringkey' }), 'lost at it')), plan.buttons(() => csvText(heads, all.map(one => heads.map(name => one[name])))));
  page.append(el('p', {}, answer.done + ' of ' + all.length + ' bearings of ' + answer.obstacle + ', ' + answer.pings + ' pings. ', el('a', { class: 'watch', href: '#' + new URLSearchParams({ capture: answer.path }) }, 'Watch this capture'), ': large type for two metres, and it follows the journal as it grows.'),
    el('div', { class: 'twin' }, el('div', {}, plan.element), el('div', {}, el('section', { class: 'readout' }, heading, el('div', { class: 'bar' }, slider), el('table', {}, readout), el('p', { class: 'note' }, 'Point at a bearing in either picture, or move the slider.')), made.element, el('section', {}, el('h3', {}, 'Distances tried'), list))));
  const reach = [...answer.edge.map(([x, z]) => Math.hypot(x, z)), ...[...all, ...(other ? other.bearings : [])].flatMap(one => [one.high_m, one.table_m, ...one.levels.map(level => level[0])])].filter(Number.isFinite);
  plan.shows([0, 0], 1.08 * Math.max(0.2, ...reach));
  requestAnimationFrame(() => choose(at));
  return () => made.close();
}
function paint(g, v, colours, table, all, others, at) {
  const u = v.unit, turn = all.length > 1 ? all[1].bearing_deg - all[0].bearing_deg : 360;
  g.strokeStyle = colours.edge; g.lineWidth = 1.5 * u;
  if (table.length) { line(g, v, table, true); g.fillStyle = colours.shade; g.fill(); g.stroke(); }
  edge(g, v, others, others.length > 1 ? others[1].bearing_deg - others[0].bearing_deg : 360, colours.c2, 2 * u, [9 * u, 5 * u]);
  for (const one of all.filter(b => b.low_m !== undefined)) { g.strokeStyle = colours.quiet; g.lineWidth = 3 * u; line(g, v, [atBearing(one.bearing_deg, one.low_m), atBearing(one.bearing_deg, one.high_m)]); g.stroke(); }
  edge(g, v, all, turn, colours.c1, 2.5 * u, []);
  const one = all[at];
  g.setLineDash([6 * u, 4 * u]); g.strokeStyle = colours.ink; g.lineWidth = 1.5 * u; line(g, v, bearingLine(v, one.bearing_deg)); g.stroke(); g.setLineDash([]);
  for (const [m, , , lost] of one.levels) {
    const [x, z] = atBearing(one.bearing_deg, m);
    g.beginPath(); g.arc(v.x(x), v.y(z), 4 * u, 0, 2 * Math.PI);
    if (lost) { g.strokeStyle = colours.ink; g.lineWidth = 2 * u; g.stroke(); } else { g.fillStyle = colours.c0; g.fill(); }
  }
}
// Between bearings that were not measured nothing is known: there is no edge.
function edge(g, v, all, turn, colour, width, dashes) {
  g.strokeStyle = colour; g.fillStyle = colour; g.lineWidth = width; g.setLineDash(dashes);
  all.forEach((one, i) => {
    if (one.threshold_m === undefined) return;
    const next = all[(i + 1) % all.length], here = atBearing(one.bearing_deg, one.threshold_m);
    if (next.threshold_m !== undefined && all.length > 1 && Math.abs((next.bearing_deg - one.bearing_deg + 360) % 360 - turn) < 1e-6) { line(g, v, [here, atBearing(next.bearing_deg, next.threshold_m)]); g.stroke(); }
    g.beginPath(); g.arc(v.x(here[0]), v.y(here[1]), 1.2 * width, 0, 2 * Math.PI); g.fill();
  });
  g.setLineDash([]);
}
