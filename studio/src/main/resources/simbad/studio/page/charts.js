// Charts along an axis: hover, drag to zoom, double click to show all.
import uPlot from './uPlot.esm.js';
import { csvText, el, give, giveText, lineKey, themeColours } from './kit.js';
import { chartSvg } from './chart-picture.js';
import { DASHES, SERIES } from './sheet.js';

// series: { name, values, colour (a name of the theme), dash, points (dots instead of a line), ring (dots that are hollow), width, fill }.
// from0: the axis upwards begins at nothing. x ascends; charts with one sync name move their cursors together; onhover is told an index.
export function chart({ name, label, x, xLabel, yLabel, series, height, sync, onhover, log, every, range, from0 }) {
  const colours = themeColours(['paper', 'ink', 'soft', 'grid', ...SERIES, 'edge', 'quiet', 'trail', 'low', 'high']);
  const host = el('div', { class: 'chart', role: 'img', tabindex: 0, 'aria-label': label + '. Arrow keys go along it.' });
  const said = el('p', { class: 'note said', role: 'status' }, '\u00a0');
  // As large as the page's words, which grow with the window.
  const px = Math.round(0.84 * parseFloat(getComputedStyle(document.documentElement).fontSize)), font = px + 'px system-ui, sans-serif';
  const axis = (title, extra) => ({ label: title, stroke: colours.ink, grid: { stroke: colours.grid, width: 1 }, ticks: { stroke: colours.grid, width: 1 }, font, labelFont: font, labelSize: 1.7 * px, size: 3.8 * px, ...extra });
  const incrs = every ? { incrs: [every / 6, every / 3, every, 2 * every, 4 * every] } : {};
  const options = {
    width: 400, height, padding: [10, 14, 0, 0], legend: { show: false },
    cursor: { sync: sync ? { key: sync, setSeries: false } : undefined, drag: { x: true, y: true, uni: 20 }, points: { size: 7 } },
    scales: { x: { time: false, range }, y: { distr: log ? 3 : 1, ...(from0 ? { range: { min: { soft: 0, mode: 1, pad: 0 }, max: { soft: 0, mode: 0, pad: 0.08 } } } : {}) } },
    axes: [axis(xLabel, incrs), axis(yLabel, { size: 4.4 * px })],
    hooks: { setCursor: [u => { if (u.cursor.idx !== null && u.cursor.idx !== undefined && u.cursor.left >= 0) say(u.cursor.idx); if (onhover && u.cursor.event && u.cursor.idx !== null) onhover(u.cursor.idx); }] },
    series: [{}, ...series.map(one => ({
      label: one.name, stroke: colours[one.colour], width: one.points ? 0 : one.width ?? 2, dash: one.dash, fill: one.fill ? colours[one.colour] + '22' : undefined,
      // Rings let be seen what they are round.
      points: { show: Boolean(one.points), size: one.ring ? 10 : 5, fill: one.ring ? 'transparent' : colours[one.colour], stroke: colours[one.colour] },
      paths: one.points ? () => null : undefined, spanGaps: false,
    }))],
  };
  const text = value => Number(value.toPrecision(4)).toString().replace('-', '\u2212');
  const say = index => {
    const parts = series.filter(one => one.values[index] !== null && one.values[index] !== undefined).map(one => one.name + ' ' + text(one.values[index]));
    said.textContent = xLabel + ' ' + text(x[index]) + ': ' + (parts.join(', ') || 'nothing');
  };
  const data = [x, ...series.map(one => log ? one.values.map(v => v === null || v > 0 ? v : null) : one.values)];
  const plot = new uPlot(options, data, host);
  const fit = new ResizeObserver(() => { if (host.clientWidth) plot.setSize({ width: host.clientWidth, height }); });
  fit.observe(host);
  let at = 0;
  const step = by => {
    // To the next place along the axis: many dots may stand at one.
    let next = at + by;
    while (next > 0 && next < x.length - 1 && x[next] === x[at]) next += by;
    go(Math.max(0, Math.min(x.length - 1, next)));
    if (onhover) onhover(at);
  };
  const go = index => { at = index; plot.setCursor({ left: plot.valToPos(x[index], 'x'), top: plot.cursor.top > 0 ? plot.cursor.top : 5 }, false); say(index); };
  host.addEventListener('keydown', event => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by && x.length) { event.preventDefault(); step(by); }
  });
  const key = el('ul', { class: 'legend' }, series.map(one => el('li', {}, one.points ? el('i', { class: 'key-' + one.colour + (one.ring ? ' rings' : ' dots') }) : lineKey(one.colour, one.dash), one.name)));
  const csv = () => csvText([xLabel, ...series.map(one => one.name)], x.map((at, i) => [at, ...series.map(one => one.values[i])]));
  const svg = () => chartSvg({ label, x, xLabel, yLabel, series, log, every, width: plot.width, height }, plot.scales, colours);
  const element = el('figure', { class: 'chartbox' }, el('figcaption', {}, label), host, said, key, el('div', { class: 'bar', role: 'group', 'aria-label': 'Save ' + name },
    el('button', { type: 'button', onclick: () => giveText(name + '.svg', svg(), 'image/svg+xml') }, 'Save SVG'),
    el('button', { type: 'button', onclick: () => plot.ctx.canvas.toBlob(blob => give(name + '.png', blob)) }, 'Save PNG'),
    el('button', { type: 'button', onclick: () => giveText(name + '.csv', csv(), 'text/csv') }, 'Save csv'),
    el('button', { type: 'button', onclick: () => { plot.setData(plot.data); } }, 'Show all')));
  return { element, plot,
    at: go,
    update(values) { series.forEach((one, i) => { one.values = values[i]; }); plot.setData([x, ...values], false); plot.redraw(); },
    close() { fit.disconnect(); plot.destroy(); } };
}
export const dash = index => DASHES[index % DASHES.length];
export const colour = index => SERIES[index % SERIES.length];
