// A plan seen from above on a canvas: the same lines draw it on the screen, as PNG and as SVG.
import { el, give, giveText, themeColours } from './kit.js';
import { SvgPen } from './pen.js';

const REST_MS = 120;
export const SERIES = ['c0', 'c1', 'c2', 'c3', 'c4', 'c5'];
const NAMES = ['paper', 'ink', 'soft', 'grid', 'shade', 'edge', 'body', 'trail', 'line', 'quiet', 'low', 'high', ...SERIES];
export const DASHES = [[], [9, 5], [2, 4], [12, 4, 2, 4], [5, 3], [1, 3]];

export function grid(g, v, unit, colours) {
  const every = v.radius > 2 ? 1 : v.radius > 0.5 ? 0.5 : v.radius > 0.2 ? 0.1 : 0.02;
  g.strokeStyle = colours.grid; g.lineWidth = unit;
  g.beginPath();
  const [x0, z0] = v.back(0, 0), [x1, z1] = v.back(v.w, v.h);
  for (let x = Math.ceil(x0 / every) * every; x <= x1; x += every) { g.moveTo(v.x(x), 0); g.lineTo(v.x(x), v.h); }
  for (let z = Math.ceil(z0 / every) * every; z <= z1; z += every) { g.moveTo(0, v.y(z)); g.lineTo(v.w, v.y(z)); }
  g.stroke();
  const long = every * v.scale, y = v.h - 14 * unit;
  g.strokeStyle = colours.soft; g.lineWidth = 2 * unit; g.beginPath(); g.moveTo(14 * unit, y); g.lineTo(14 * unit + long, y); g.stroke();
  g.fillStyle = colours.soft; g.font = Math.max(13, 12 * unit) + 'px system-ui, sans-serif'; g.textBaseline = 'bottom'; g.textAlign = 'left';
  g.fillText(every >= 0.5 ? every + ' m' : Math.round(every * 100) + ' cm', 14 * unit, y - 4 * unit);
}
export function line(g, v, points, closed) {
  g.beginPath();
  points.forEach(([x, z], i) => g[i ? 'lineTo' : 'moveTo'](v.x(x), v.y(z)));
  if (closed) g.closePath();
}
// Where a bearing of an obstacle at the origin lies: 0 looks down the page, 90 to the right.
export const atBearing = (deg, m) => [m * Math.sin(deg * Math.PI / 180), m * Math.cos(deg * Math.PI / 180)];

// The part of the line at a bearing that may be seen: dashes that nobody sees take time as well.
export function bearingLine(v, deg) {
  const middle = Math.hypot(...v.centre), beside = (v.w + v.h) / v.scale;
  return [atBearing(deg, Math.max(0, middle - beside)), atBearing(deg, middle + beside)];
}
// Dashes of what is very long on the screen cost more than a picture may: then a line is drawn through.
const MOST_DASHED_PX = 20000;
export const dashes = (v, lengthM, dash) => lengthM * v.scale > MOST_DASHED_PX ? [] : dash.map(d => d * v.unit);

export class Sheet {
  // paint(g, v, colours) draws all; zoom by wheel and keys, drag moves, double click shows all.
  constructor(label, name, paint) {
    Object.assign(this, { name, paint, radius: 1, middle: [0, 0], zoom: 1, off: [0, 0] });
    this.canvas = el('canvas', { tabindex: 0, role: 'img', 'aria-label': label, class: 'sheet' });
    this.element = el('figure', {}, this.canvas);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    this.listen();
  }
  shows(middle, radius) { this.middle = middle; this.radius = radius; this.draw(); }
  view() {
    const w = this.canvas.clientWidth, h = this.canvas.clientHeight, radius = this.radius / this.zoom;
    const scale = Math.min(w, h) / (2 * radius), centre = [this.middle[0] + this.off[0], this.middle[1] + this.off[1]];
    return { w, h, scale, centre, radius, unit: Math.max(1, Math.min(w, h) / 500), x: m => w / 2 + (m - centre[0]) * scale, y: m => h / 2 + (m - centre[1]) * scale,
      back: (px, py) => [(px - w / 2) / scale + centre[0], (py - h / 2) / scale + centre[1]] };
  }
  // Not oftener than the screen shows it: a wheel turns faster.
  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.draw(); });
  }
  draw(pen) {
    const canvas = this.canvas, ratio = devicePixelRatio || 1, v = this.view();
    if (!v.w || !v.h) return;
    if (!pen && (canvas.width !== Math.round(v.w * ratio) || canvas.height !== Math.round(v.h * ratio))) {
      canvas.width = Math.round(v.w * ratio); canvas.height = Math.round(v.h * ratio);
    }
    const g = pen || canvas.getContext('2d'), colours = themeColours(NAMES);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.lineJoin = 'round';
    g.setLineDash([]);
    g.fillStyle = colours.paper; g.fillRect(0, 0, v.w, v.h);
    grid(g, v, v.unit, colours);
    this.paint(g, v, colours);
  }
  svg() {
    const v = this.view(), pen = new SvgPen(v.w, v.h);
    this.draw(pen);
    return pen.text(this.canvas.getAttribute('aria-label'));
  }
  buttons(csv) {
    return el('div', { class: 'bar', role: 'group', 'aria-label': 'Save ' + this.name },
      el('button', { type: 'button', onclick: () => giveText(this.name + '.svg', this.svg(), 'image/svg+xml') }, 'Save SVG'),
      el('button', { type: 'button', onclick: () => this.canvas.toBlob(blob => give(this.name + '.png', blob)) }, 'Save PNG'),
      csv ? el('button', { type: 'button', onclick: () => giveText(this.name + '.csv', csv(), 'text/csv') }, 'Save csv') : null);
  }
  listen() {
    const canvas = this.canvas, spot = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
    let from = null;
    canvas.addEventListener('wheel', event => {
      if (!event.ctrlKey && document.activeElement !== canvas) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-event.deltaY / 400), ...spot(event));
    }, { passive: false });
    canvas.addEventListener('pointerdown', event => { from = spot(event); canvas.setPointerCapture(event.pointerId); });
    canvas.addEventListener('pointermove', event => {
      const p = spot(event), v = this.view();
      if (from) {
        this.off = [this.off[0] - (p[0] - from[0]) / v.scale, this.off[1] - (p[1] - from[1]) / v.scale];
        from = p;
        this.looked();
      } else if (this.onpoint) this.onpoint(v.back(...p), v, p);
    });
    canvas.addEventListener('pointerup', () => { from = null; });
    canvas.addEventListener('pointercancel', () => { from = null; });
    canvas.addEventListener('dblclick', () => this.reset());
    canvas.addEventListener('keydown', event => {
      const act = { '+': () => this.zoomBy(1.25), '-': () => this.zoomBy(0.8), '0': () => this.reset() }[event.key];
      if (act) { event.preventDefault(); act(); } else if (this.onkey && this.onkey(event.key)) event.preventDefault();
    });
  }
  zoomBy(times, px, py) {
    const v = this.view(), at = v.back(px ?? v.w / 2, py ?? v.h / 2);
    const zoom = Math.max(1, Math.min(200, this.zoom * times)), share = 1 - this.zoom / zoom;
    this.off = this.off.map((o, i) => o + (at[i] - v.centre[i]) * share);
    this.zoom = zoom;
    if (zoom === 1) this.off = [0, 0];
    this.looked();
  }
  reset() { this.zoom = 1; this.off = [0, 0]; this.looked(); }
  // Somebody looks elsewhere: what is seen there may be asked for when the hand rests.
  looked() {
    this.redraw();
    clearTimeout(this.resting);
    if (this.onlook) this.resting = setTimeout(() => this.onlook(this.box()), REST_MS);
  }
  // What is seen, with as much again on each side.
  box() {
    const v = this.view(), [x0, z0] = v.back(-v.w, -v.h), [x1, z1] = v.back(2 * v.w, 2 * v.h);
    return [x0, z0, x1, z1];
  }
}
