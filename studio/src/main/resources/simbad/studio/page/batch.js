// A batch: a dot per run, one column against another, and what each sensor came to.
import { el, number, table } from './kit.js';
import { chart, colour } from './charts.js';
import { SERIES } from './sheet.js';

const LISTED = 100;

export function showBatch(page, answer, other) {
  const both = [answer, other].filter(Boolean), columns = answer.columns;
  const at = (source, name) => source.columns.indexOf(name);
  const value = (source, row, name) => { const text = row[at(source, name)]; return text === undefined || text === '' || !Number.isFinite(Number(text)) ? null : Number(text); };
  const numeric = columns.filter(name => answer.rows.some(row => value(answer, row, name) !== null));
  const failed = answer.rows.filter(row => row[at(answer, 'status')] === 'failed').length;
  const pick = (label, names, first) => { const choice = el('select', { onchange: () => draw() }, names.map(name => el('option', { value: name, selected: name === first }, name))); return [el('label', {}, label, choice), choice]; };
  const [xLabel, xs] = pick('Across', numeric, numeric.includes('speed_m_per_s') ? 'run' : numeric[0]);
  const [yLabel, ys] = pick('Up', numeric, numeric.includes('mean_abs_cm') ? 'mean_abs_cm' : numeric[0]);
  const [byLabel, by] = pick('Colour', columns.filter(name => name !== 'error'), 'sensor');
  const host = el('div');
  let made = null;
  const draw = () => {
    const dots = both.flatMap((source, k) => source.rows.map(row => ({ x: value(source, row, xs.value), y: value(source, row, ys.value), of: (row[at(source, by.value)] ?? '') + (k ? ' \u00b7 ' + source.path : '') }))).filter(dot => dot.x !== null && dot.y !== null).sort((a, b) => a.x - b.x);
    const groups = [...new Set(dots.map(dot => dot.of))].sort().slice(0, 12);
    if (made) made.close();
    host.replaceChildren();
    made = chart({ name: 'batch', label: ys.value + ' against ' + xs.value, x: dots.map(dot => dot.x), xLabel: xs.value, yLabel: ys.value, height: 380,
      series: groups.map((group, i) => ({ name: group || '(empty)', values: dots.map(dot => dot.of === group ? dot.y : null), colour: colour(i), points: true, ring: i >= SERIES.length })) });
    host.append(made.element);
  };
  const middle = list => { const sorted = list.filter(v => v !== null).sort((a, b) => a - b); const half = sorted.length / 2; return sorted.length ? (sorted[Math.ceil(half) - 1] + sorted[Math.floor(half)]) / 2 : null; };
  const kept = share => share === null ? '\u2013' : number(100 * share, 1) + ' %';
  const groupRows = both.flatMap((source, k) => {
    const keys = [...new Set(source.rows.map(row => row[at(source, 'obstacle')] + '\n' + row[at(source, 'sensor')]))];
    return keys.map(key => {
      const rows = source.rows.filter(row => row[at(source, 'obstacle')] + '\n' + row[at(source, 'sensor')] === key);
      return [...(other ? [source.path] : []), ...key.split('\n'), String(rows.length), ...['mean_abs_cm', 'lateral_mean_cm'].map(name => number(middle(rows.map(row => value(source, row, name))), 2)),
        kept(middle(rows.map(row => value(source, row, 'edge_kept'))))];
    });
  });
  page.append(el('section', {}, el('p', {}, answer.all_rows + ' runs, ' + failed + ' failed.' + (answer.all_rows > answer.rows.length ? ' The first ' + answer.rows.length + ' are shown.' : '') + ' Medians of the runs:'),
    table('Medians', [...(other ? ['batch'] : []), 'obstacle', 'sensor', '#runs', '#mean cm', '#beside cm', '#edge kept'], groupRows)),
  el('section', {}, el('div', { class: 'fields' }, xLabel, yLabel, byLabel), host),
  el('section', {}, el('h3', {}, 'Runs'), table('Runs', columns, answer.rows.slice(0, LISTED)), answer.rows.length > LISTED ? el('p', { class: 'note' }, 'The first ' + LISTED + ' rows; the csv of the chart has all dots.') : null));
  draw();
  return () => { if (made) made.close(); };
}
