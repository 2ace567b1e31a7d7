// A diagnosis in words and bars, alone or beside another.
import { csvText, el, giveText, number, table, themeColours } from './kit.js';
import { SvgPen } from './pen.js';

export const percent = share => share === null || share === undefined ? '\u2013' : share > 0.995 && share < 1 ? '> 99 %' : share > 0 && share < 0.005 ? '< 1 %' : number(100 * share, 0) + ' %';
const UNITS = [['_m_s', ' m/s'], ['_rad_s', ' rad/s'], ['_deg_s', ' \u00b0/s'], ['_per_m', ' 1/m'], ['_deg', '\u00b0'], ['_cm', ' cm'], ['_db', ' dB'], ['_m', ' m'], ['_s', ' s']];
export function unit(name) { const found = UNITS.find(([end]) => name.endsWith(end)); return found ? found[1] : ''; }
// Clocks that count from 1970 need all their digits.
const end = (key, value) => key === 't_s' ? number(value, 1).replace(/\.0$/, '') : String(Number(value.toPrecision(3))).replace('-', '\u2212');
export function place(slice) {
  const names = { bearing_deg: 'bearing', distance_m: 'distance', off_axis_deg: 'off-axis angle', t_s: 'time', speed_m_s: 'speed', turn_rad_s: 'turn rate', since_change_s: 'since the last change', speed_change_m_s: 'change of speed', heading_deg: 'heading', x_m: 'x', z_m: 'z' };
  const all = Object.entries(slice).map(([key, value]) => (names[key] || key) + ' ' + (typeof value === 'string' ? value
    : value[0] === null ? 'below ' + end(key, value[1]) + unit(key) : value[1] === null ? 'from ' + end(key, value[0]) + unit(key) : end(key, value[0]) + ' to ' + end(key, value[1]) + unit(key)));
  return all.join(', ') || 'everywhere';
}
// A bar of its share of the largest; the words beside it say the same.
export function bar(name, share, text, style) {
  const fill = el('span', { class: 'fill ' + style });
  fill.style.width = 100 * Math.max(0, Math.min(1, share)) + '%';
  return [el('span', {}, name), el('span', { class: 'track' }, fill), el('span', { class: 'value' }, text)];
}
// The same bars as a picture: rows of name, share of the width, words and the theme's colour.
const ROW_PX = 28, NAME_PX = 200, BAR_PX = 400;
export function barsSvg(title, rows) {
  const colours = themeColours(['paper', 'ink', 'line', ...new Set(rows.map(row => row.colour))]), pen = new SvgPen(NAME_PX + BAR_PX + 160, ROW_PX * (rows.length + 1));
  const put = (colour, x, y, w, h) => { pen.fillStyle = colours[colour]; pen.fillRect(x, y, w, h); }, write = (text, x, y) => { pen.fillStyle = colours.ink; pen.font = '14px'; pen.fillText(text, x, y); };
  put('paper', 0, 0, pen.w, pen.h);
  write(title, 10, 20);
  rows.forEach((row, i) => {
    const y = ROW_PX * (i + 1), low = Math.max(0, Math.min(1, row.from || 0)), share = Math.max(0, Math.min(1 - low, row.share));
    write(row.name, 10, y + 18); put('line', NAME_PX, y + 4, BAR_PX, 18); put(row.colour, NAME_PX + low * BAR_PX, y + 4, share * BAR_PX, 18); write(row.text, NAME_PX + BAR_PX + 10, y + 18);
  });
  return pen.text(title);
}
// Buttons that save bars as a picture and their numbers.
export function saveBars(name, title, rows, heads, numbers) {
  return el('div', { class: 'bar', role: 'group', 'aria-label': 'Save ' + name }, el('button', { type: 'button', onclick: () => giveText(name + '.svg', barsSvg(title, rows()), 'image/svg+xml') }, 'Save SVG'),
    el('button', { type: 'button', onclick: () => giveText(name + '.csv', csvText(heads, numbers), 'text/csv') }, 'Save csv'));
}
export function verdict(diagnosis) {
  const named = (diagnosis.explanation || []).join(', ');
  const said = el('section', {}, el('p', { class: 'verdict' }, el('strong', {}, diagnosis.verdict || 'audited only'), named ? ': ' + named : ''),
    diagnosis.headline ? el('p', {}, diagnosis.headline) : null, diagnosis.reason ? el('p', {}, diagnosis.reason + '.') : null);
  for (const finding of diagnosis.audit || []) said.append(el('p', { class: 'note' }, 'Audit, ' + finding.severity + ': ' + finding.what));
  return said;
}
export function gapBars(gap, most) {
  const scale = most || Math.max(gap.before_cm, gap.after_cm, gap.floor_cm);
  const shrink = gap.shrink_ci95 || [null, null];
  return el('section', {}, el('h3', {}, 'Gap on rows that the fit never saw, cm'), el('div', { class: 'bars' },
    bar('before', gap.before_cm / scale, number(gap.before_cm, 2), 'before'), bar('after', gap.after_cm / scale, number(gap.after_cm, 2), 'after'), bar('floor', gap.floor_cm / scale, number(gap.floor_cm, 2), 'floor')),
  el('p', { class: 'note' }, 'It shrinks by ' + percent(gap.shrink) + ' (95 % interval ' + percent(shrink[0]) + ' to ' + percent(shrink[1]) + '), measured on ' + gap.rows_held_out + ' rows.'),
  saveBars('gap', 'Gap on rows that the fit never saw, cm', () => [['before', 'c1'], ['after', 'c0'], ['floor', 'quiet']].map(([name, colour]) => ({ name, colour, share: gap[name + '_cm'] / scale, text: number(gap[name + '_cm'], 2) })),
    ['what', 'cm'], ['before', 'after', 'floor'].map(name => [name, gap[name + '_cm']])));
}
// The theme's colours of the classes in folders.css.
const COLOURS = { unknown: 'c3', floor: 'quiet', effect0: 'c0', effect1: 'c4', effect2: 'c2' };
// Parts in centimetres, or as shares where there are several units.
export function budget(entries) {
  const inCm = entries.some(one => one.cm !== undefined), value = one => inCm ? one.cm : one.share, text = v => inCm ? number(v, 2) : percent(v);
  const all = entries.reduce((sum, one) => sum + Math.max(0, value(one)), 0);
  if (!(all > 0)) return null;
  const style = (one, i) => one.what === 'rest' ? 'unknown' : one.what === 'floor' ? 'floor' : 'effect' + Math.min(2, i);
  const name = one => one.what === 'rest' ? 'not explained' : one.what === 'floor' ? 'scatter (floor)' : one.what;
  const part = (one, i) => { const made = el('span', { class: 'fill ' + style(one, i) }); made.style.flexGrow = Math.max(0, value(one)) / all; return made; };
  return el('section', {}, el('h3', {}, 'Parts of the gap before' + (inCm ? ', cm' : '')), el('div', { class: 'budget', 'aria-hidden': 'true' }, entries.map(part)),
    el('ul', { class: 'legend' }, entries.map((one, i) => el('li', {}, el('i', { class: 'block ' + style(one, i) }), name(one) + ' ' + text(value(one)) + ' (' + text(one.ci95[0]) + ' to ' + text(one.ci95[1]) + ')'))),
    saveBars('parts', 'Parts of the gap before' + (inCm ? ', cm' : ''), () => { let from = 0; return entries.map((one, i) => { const share = Math.max(0, value(one)) / all, row = { name: name(one), colour: COLOURS[style(one, i)], from, share, text: text(value(one)) }; from += share; return row; }); },
      ['part', inCm ? 'cm' : 'share', 'low', 'high'], entries.map(one => [one.what, value(one), ...one.ci95])));
}
// As many digits as the interval tells, three at least.
function digits(value, ends) {
  const told = ends[0] === null || ends[1] === null ? 0 : Math.ceil(Math.log10(Math.abs(value) / (ends[1] - ends[0]))) + 1;
  return String(Number(value.toPrecision(Number.isFinite(told) ? Math.min(6, Math.max(3, told)) : 3))).replace('-', '\u2212');
}
const LEAST = 0.01, MOST_VALUES = 6;
export function effects(diagnosis, other) {
  const of = (source, name) => source && (source.effects || []).find(one => one.name === name);
  const names = [...new Set([diagnosis, other].filter(Boolean).flatMap(one => (one.effects || []).filter(e => e.probability >= LEAST || (one.explanation || []).includes(e.name)).map(e => e.name)))];
  const values = effect => {
    const all = effect ? Object.entries(effect.parameters || {}) : [];
    return !effect ? '\u2013' : all.length > MOST_VALUES ? all.length + ' values: the curve below' : all.map(([key, value]) => {
    const ends = (effect.ci95 || {})[key] || [null, null];
    return key + ' ' + (value === null ? 'no bound' : digits(value, ends)) + unit(key) + (ends[0] === null || ends[1] === null ? '' : ' (' + digits(ends[0], ends) + ' to ' + digits(ends[1], ends) + ')');
    }).join('; ');
  };
  const heads = other ? ['effect', '#this one', 'values', '#the other', 'values'] : ['effect', '#probability', 'values, with 95 % intervals', 'what to do'];
  const rows = names.map(name => { const a = of(diagnosis, name), b = of(other, name); return other ? [name, percent(a && a.probability), values(a), percent(b && b.probability), values(b)] : [name, percent(a.probability), values(a), a.remedy || '']; });
  const unknown = other ? ['unknown', percent(diagnosis.unknown_probability), '', percent(other.unknown_probability), ''] : ['unknown', percent(diagnosis.unknown_probability), '', ''];
  return el('section', { class: 'effects' }, el('h3', {}, 'Effects at work'), table('Effects at work', heads, [...rows, unknown]));
}
