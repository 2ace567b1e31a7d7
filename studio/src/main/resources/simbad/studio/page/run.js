// A run: where the robot drove, and what each sensor was off by at each bearing.
import { ask, el, csvText, fault, lineKey, number, table } from './kit.js';
import { chart, colour, dash } from './charts.js';
import { atBearing, bearingLine, dashes, line, Sheet } from './sheet.js';

export function showRun(page, run, other) {
  const names = [...new Set([...run.obstacles, ...(other ? other.obstacles : [])].map(one => one.name))];
  const body = el('div', { class: 'opened' });
  let close = () => {};
  const show = name => { close(); body.replaceChildren(); close = obstacle(body, name, run, other); };
  const choice = el('select', { onchange: () => show(choice.value) }, names.map(name => el('option', { value: name }, name)));
  if (names.length > 1) page.append(el('label', { class: 'search' }, 'Obstacle', choice));
  page.append(body);
  show(names[0]);
  return () => close();
}
// The sensors of both runs, each with its colour and dashes.
function sensorsOf(name, run, other) {
  const of = (source, mark) => {
    const found = source && source.obstacles.find(one => one.name === name);
    return found ? Object.keys(found.errors_m).map(sensor => ({ sensor: sensor + mark, errors: found.errors_m[sensor], pieces: found.traces[sensor] || [], sensorName: sensor, source, of: found, result: source.errors.results.find(r => r.obstacle === name && r.sensor === sensor) || {} })) : [];
  };
  const all = [...of(run, ''), ...of(other, ' \u00b7 ' + (other ? other.path : ''))];
  // The first colour is the table's. Dashes tell lines apart where colours do not.
  return all.map((one, i) => ({ ...one, colour: colour(i + 1), dash: dash(i) }));
}
function obstacle(body, name, run, other) {
  const sensors = sensorsOf(name, run, other), main = sensors[0].of, bearings = main.table.map(row => row[0]);
  let at = 0;
  const errorOf = (one, index) => { const i = Math.round(index / bearings.length * one.errors.length) % one.errors.length; return one.errors[i]; };
  const cm = one => bearings.map((b, i) => errorOf(one, i) === null ? null : 100 * errorOf(one, i));
  const plan = new Sheet('Traces round ' + name + ', seen from above, with the edge of the table', 'traces-' + name, (g, v, colours) => paint(g, v, colours, main, sensors, bearings[at], main.table[at][1]));
  const errors = chart({ name: 'errors-' + name, label: 'Radial error by bearing, cm', x: bearings, xLabel: 'bearing, degrees', yLabel: 'error, cm', every: 30, sync: 'bearing', height: 260,
    series: sensors.map(one => ({ name: one.sensor, values: cm(one), colour: one.colour, dash: one.dash })), onhover: index => choose(index) });
  const banded = main.table[0].length > 2;
  const lobes = chart({ name: 'table-' + name, label: 'The table\u2019s threshold by bearing, m: its lobes', x: bearings, xLabel: 'bearing, degrees', yLabel: 'threshold, m', every: 30, from0: true, sync: 'bearing', height: 200,
    series: [{ name: 'threshold (' + main.provenance + ')', values: main.table.map(row => row[1]), colour: 'edge', fill: true },
      ...(banded ? [{ name: 'interval, low', values: main.table.map(row => row[2]), colour: 'quiet', dash: dash(1), width: 1 }, { name: 'interval, high', values: main.table.map(row => row[3]), colour: 'quiet', dash: dash(1), width: 1 }] : [])],
    onhover: index => choose(index) });
  const slider = el('input', { type: 'range', min: 0, max: bearings.length - 1, step: 1, value: 0, 'aria-label': 'Bearing', oninput: () => choose(Number(slider.value)) });
  const readout = el('tbody'), heading = el('h3', {}, ' ');
  const choose = index => {
    at = index;
    slider.value = index;
    slider.setAttribute('aria-valuetext', bearings[index] + ' degrees');
    heading.textContent = 'At bearing ' + bearings[index] + '\u00b0';
    const row = main.table[index];
    readout.replaceChildren(...[['table', number(row[1], 2) + ' m'], ['interval', row.length > 2 ? number(row[2], 2) + ' to ' + number(row[3], 2) + ' m' : 'not stated'], ...(main.pings ? [['pings', main.pings]] : []),
      ...sensors.map(one => [one.sensor, errorOf(one, index) === null ? 'not reached' : number(100 * errorOf(one, index), 1) + ' cm off'])]
      .map(([what, value]) => el('tr', {}, el('th', { scope: 'row' }, what), el('td', { class: 'r' }, value))));
    errors.at(index); lobes.at(index);
    plan.draw();
  };
  const toIndex = ([x, z]) => Math.round((Math.atan2(x, z) * 180 / Math.PI + 360) % 360 / 360 * bearings.length) % bearings.length;
  plan.onpoint = point => choose(toIndex(point));
  plan.onkey = key => { const by = { ArrowLeft: -1, ArrowRight: 1 }[key]; if (by) choose((at + by + bearings.length) % bearings.length); return Boolean(by); };
  let looks = 0;
  plan.onlook = async box => {
    const mine = ++looks;
    if (plan.zoom === 1) { for (const one of sensors) one.near = null; plan.draw(); return; }
    for (const source of new Set(sensors.map(one => one.source))) {
      try {
        const answer = await ask('/trace', { path: source.path, obstacle: name, box });
        if (mine !== looks) return;
        if (answer.fault) throw new Error(answer.fault);
        for (const one of sensors.filter(own => own.source === source)) one.near = { box, pieces: answer.traces[one.sensorName] || [] };
      } catch (e) { fault(e.message); }
    }
    plan.draw();
  };
  const csv = () => csvText(['sensor', 'x_m', 'z_m'], sensors.flatMap(one => one.pieces.flat().map(([x, z]) => [one.sensor, x, z])));
  plan.element.append(el('ul', { class: 'legend' }, el('li', {}, lineKey('edge'), 'edge of the table'),
    sensors.map(one => el('li', {}, lineKey(one.colour, one.dash), one.sensor))), plan.buttons(csv));
  const reads = el('section', { class: 'readout' }, heading, el('div', { class: 'bar' }, slider), el('table', {}, readout), el('p', { class: 'note' }, 'Point at a bearing in any of the pictures, or move the slider.'));
  body.append(el('div', { class: 'twin' }, el('div', {}, plan.element), el('div', {}, reads, errors.element, lobes.element)), summary(name, sensors));
  const reach = Math.max(...main.table.map(row => row[1]), ...sensors.flatMap(one => one.pieces.flat().map(([x, z]) => Math.hypot(x, z))));
  plan.shows([0, 0], 1.08 * reach);
  requestAnimationFrame(() => choose(0));
  return () => { errors.close(); lobes.close(); };
}
const covers = ([x0, z0, x1, z1], v) => { const [left, top] = v.back(0, 0), [right, bottom] = v.back(v.w, v.h); return x0 <= left && z0 <= top && x1 >= right && z1 >= bottom && v.radius > (x1 - x0) / 24; };
const ways = new WeakMap();
// How long a trace is.
function wayM(pieces) {
  if (!ways.has(pieces)) ways.set(pieces, pieces.reduce((sum, piece) => piece.reduce((all, [x, z], i) => i ? all + Math.hypot(x - piece[i - 1][0], z - piece[i - 1][1]) : all, sum), 0));
  return ways.get(pieces);
}
function paint(g, v, colours, main, sensors, bearing, threshold) {
  const u = v.unit;
  line(g, v, main.table.map(([b, m]) => atBearing(b, m)), true);
  g.fillStyle = colours.shade; g.fill();
  g.globalAlpha = 0.45; g.strokeStyle = colours.edge; g.lineWidth = 5 * u; g.stroke(); g.globalAlpha = 1;
  for (const k of main.table[0].length > 2 ? [2, 3] : []) {
    g.setLineDash(dashes(v, 2 * Math.PI * main.table[0][k], [3, 3])); g.lineWidth = u; g.strokeStyle = colours.quiet;
    line(g, v, main.table.map(row => atBearing(row[0], row[k])), true); g.stroke();
  }
  for (const one of sensors) {
    // As fine as the screen shows it where that is known, else as the whole was given.
    const pieces = one.near && covers(one.near.box, v) ? one.near.pieces : one.pieces;
    g.setLineDash(dashes(v, wayM(pieces), one.dash));
    g.strokeStyle = colours[one.colour]; g.lineWidth = 1.8 * u;
    for (const piece of pieces) { line(g, v, piece); g.stroke(); }
  }
  g.setLineDash([]);
  g.fillStyle = colours.body; g.strokeStyle = colours.body; g.lineWidth = u;
  for (const part of main.parts) { line(g, v, part, true); g.fill(); g.stroke(); }
  const [tx, tz] = atBearing(bearing, threshold);
  g.setLineDash([6 * u, 4 * u]); g.strokeStyle = colours.ink; g.lineWidth = 1.5 * u;
  line(g, v, bearingLine(v, bearing)); g.stroke();
  g.setLineDash([]); g.fillStyle = colours.ink;
  g.beginPath(); g.arc(v.x(tx), v.y(tz), 4.5 * u, 0, 2 * Math.PI); g.fill();
}
// The words are those of the program's own tables (ErrorWords).
function summary(name, sensors) {
  return el('section', {}, el('h3', {}, 'Errors round ' + name), table('Errors round ' + name,
    ['sensor', '#mean cm', '#RMS cm', '#max cm', '#beside cm', '#edge kept', '#from edge', '#unreached'],
    sensors.map(({ sensor, result: r }) => [sensor, number(r.mean_abs_cm, 2), number(r.rms_cm, 2), number(r.max_abs_cm, 2), number(r.lateral_mean_cm, 2),
      r.edge_kept === null || r.edge_kept === undefined ? '\u2013' : number(100 * r.edge_kept, 1) + ' %', number(r.edge_to_trace_max_cm, 2), r.unreached_bearings + '/' + r.bearings])));
}
