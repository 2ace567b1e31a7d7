// A chart as SVG: the part of it that is shown, with its axes and the key of its lines.
import { SvgPen } from './pen.js';

const LEFT = 64, RIGHT = 16, TOP = 56, UNDER = 44, KEY_PX = 20, FONT = '13px', TICKS = 8, DOT = 2.5, RING = 5;
const text = value => Number(value.toPrecision(6)).toString().replace('-', '\u2212');

// Round steps between two ends; of degrees those that divide a turn; of a logarithm the powers of ten.
export function ticks(low, high, { every, log } = {}) {
  if (log) {
    const powers = [];
    for (let p = Math.ceil(Math.log10(low) - 1e-9); p <= Math.log10(high) + 1e-9; p++) powers.push(10 ** p);
    return powers;
  }
  if (!(high > low)) return [low];
  const least = (high - low) / TICKS, tens = 10 ** Math.floor(Math.log10(least));
  const step = (every ? [every / 6, every / 3, every, 2 * every, 3 * every] : []).find(s => s >= least) ?? [1, 2, 5, 10].map(k => k * tens).find(s => s >= least * (1 - 1e-9));
  const all = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) all.push(k * step);
  return all;
}
// spec is what the chart was made of; scales has the ends that are shown; colours are the theme's.
export function chartSvg({ label, x, xLabel, yLabel, series, log, every, width, height }, scales, colours) {
  const named = series.filter(one => one.values.some(v => v !== null && v !== undefined));
  const whole = new SvgPen(width, height + KEY_PX * named.length + 20), w = width - LEFT - RIGHT, h = height - TOP - UNDER, inner = new SvgPen(w, h);
  const up = value => log ? Math.log10(value) : value, [low, high] = [up(scales.y.min), up(scales.y.max)];
  const px = value => (value - scales.x.min) / (scales.x.max - scales.x.min || 1) * w, py = value => h - (up(value) - low) / (high - low || 1) * h;
  whole.fillStyle = colours.paper; whole.fillRect(0, 0, whole.w, whole.h);
  axes(whole, { w, h, px, py, xs: ticks(scales.x.min, scales.x.max, { every }), ys: ticks(scales.y.min, scales.y.max, { log }) }, colours);
  write(whole, label, LEFT, 20, colours.ink); write(whole, yLabel, LEFT, TOP - 12, colours.soft); write(whole, xLabel, LEFT + w / 2, TOP + h + 38, colours.soft, 'center');
  for (const one of named) draw(inner, one, x, px, py, h, colours, log);
  whole.parts.push('<svg x="' + LEFT + '" y="' + TOP + '" width="' + w + '" height="' + h + '" overflow="hidden">\n' + inner.parts.join('\n') + '\n</svg>');
  named.forEach((one, i) => key(whole, one, height + 10 + KEY_PX * i, colours));
  return whole.text(label);
}
function write(pen, words, x, y, colour, align = 'left') {
  pen.fillStyle = colour; pen.font = FONT; pen.textAlign = align;
  pen.fillText(words, x, y);
}
function axes(pen, { w, h, px, py, xs, ys }, colours) {
  pen.strokeStyle = colours.grid; pen.lineWidth = 1; pen.setLineDash([]);
  pen.beginPath();
  for (const value of xs) { pen.moveTo(LEFT + px(value), TOP); pen.lineTo(LEFT + px(value), TOP + h); }
  for (const value of ys) { pen.moveTo(LEFT, TOP + py(value)); pen.lineTo(LEFT + w, TOP + py(value)); }
  pen.stroke();
  for (const value of xs) write(pen, text(value), LEFT + px(value), TOP + h + 18, colours.ink, 'center');
  for (const value of ys) write(pen, text(value), LEFT - 8, TOP + py(value) + 4, colours.ink, 'right');
}
function style(pen, one, colours) {
  pen.strokeStyle = pen.fillStyle = colours[one.colour];
  pen.lineWidth = one.width ?? 2;
  pen.setLineDash(one.points ? [] : one.dash ?? []);
}
function draw(pen, one, x, px, py, h, colours, log) {
  style(pen, one, colours);
  const shown = x.map((at, i) => { const value = one.values[i]; return value === null || value === undefined || log && !(value > 0) ? null : [px(at), py(value)]; });
  if (one.points) return shown.filter(Boolean).forEach(([a, b]) => dot(pen, a, b, one.ring));
  const pieces = [];
  shown.forEach((point, i) => { if (!point) return; if (i === 0 || !shown[i - 1]) pieces.push([]); pieces.at(-1).push(point); });
  for (const piece of pieces) {
    if (one.fill) {
      pen.beginPath();
      for (const point of [[piece[0][0], h], ...piece, [piece.at(-1)[0], h]]) pen.lineTo(...point);
      pen.globalAlpha = 0.13; pen.fill(); pen.globalAlpha = 1;
    }
    pen.beginPath();
    for (const point of piece) pen.lineTo(...point);
    pen.stroke();
  }
}
function dot(pen, x, y, ring) {
  pen.beginPath(); pen.arc(x, y, ring ? RING : DOT, 0, 2 * Math.PI);
  if (ring) { pen.lineWidth = 1; pen.stroke(); } else pen.fill();
}
function key(pen, one, y, colours) {
  style(pen, one, colours);
  if (one.points) dot(pen, LEFT + 17, y + 4, one.ring);
  else { pen.beginPath(); pen.moveTo(LEFT, y + 4); pen.lineTo(LEFT + 34, y + 4); pen.stroke(); }
  write(pen, one.name, LEFT + 44, y + 8, colours.ink);
}
