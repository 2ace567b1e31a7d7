import { escaped } from './kit.js';

// Takes what a canvas is told to draw, and gives it as SVG: both pictures are made by the same lines.
export class SvgPen {
  constructor(w, h) { Object.assign(this, { w, h, parts: [], d: '', dash: '', globalAlpha: 1, lineWidth: 1, lineJoin: 'miter' }); }
  at(x, y) { return x.toFixed(2) + ' ' + y.toFixed(2); }
  setTransform() { }
  beginPath() { this.d = ''; }
  moveTo(x, y) { this.d += 'M' + this.at(x, y); }
  lineTo(x, y) { this.d += (this.d ? 'L' : 'M') + this.at(x, y); }
  closePath() { this.d += 'Z'; }
  rect(x, y, w, h) { this.d += 'M' + this.at(x, y) + 'h' + w + 'v' + h + 'h' + -w + 'Z'; }
  arc(x, y, r, from, to) {
    this.lineTo(x + r * Math.cos(from), y + r * Math.sin(from));
    // One arc of SVG cannot be a whole circle.
    for (const a of [(from + to) / 2, to])
      this.d += 'A' + this.at(r, r) + ' 0 0 1 ' + this.at(x + r * Math.cos(a), y + r * Math.sin(a));
  }
  setLineDash(dash) { this.dash = dash.length ? ' stroke-dasharray="' + dash.join(' ') + '"' : ''; }
  // An opacity in a colour's last two digits is known to browsers only.
  paint(what, colour) {
    const alpha = this.globalAlpha * (colour.length === 9 ? parseInt(colour.slice(7), 16) / 255 : 1);
    return ' ' + what + '="' + colour.slice(0, 7) + '"' + (alpha < 1 ? ' ' + what + '-opacity="' + alpha.toFixed(3) + '"' : '');
  }
  fill() { this.parts.push('<path d="' + this.d + '"' + this.paint('fill', this.fillStyle) + '/>'); }
  stroke() {
    this.parts.push('<path d="' + this.d + '" fill="none"' + this.paint('stroke', this.strokeStyle) + ' stroke-width="' + this.lineWidth
      + '" stroke-linejoin="' + this.lineJoin + '"' + this.dash + '/>');
  }
  fillRect(x, y, w, h) { this.beginPath(); this.rect(x, y, w, h); this.fill(); }
  fillText(text, x, y) {
    const anchor = { center: ' text-anchor="middle"', right: ' text-anchor="end"' }[this.textAlign] ?? '';
    this.parts.push('<text x="' + x + '" y="' + y + '"' + anchor + ' font-family="sans-serif" font-size="' + parseFloat(this.font) + '"' + this.paint('fill', this.fillStyle)
      + '>' + escaped(text) + '</text>');
  }
  text(title) {
    return '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ' + this.w + ' ' + this.h + '" width="' + this.w + '" height="' + this.h + '">\n<title>'
      + escaped(title) + '</title>\n' + this.parts.join('\n') + '\n</svg>\n';
  }
}
// Pictures beside each other as one: draw(i, pen) draws each.
export function pair(sizes, draw, title) {
  let x = 0;
  const parts = sizes.map(([w, h], i) => {
    const pen = new SvgPen(w, h), at = x;
    draw(i, pen);
    x += w;
    return '<svg x="' + at + '" width="' + w + '" height="' + h + '">\n' + pen.parts.join('\n') + '\n</svg>';
  });
  const whole = new SvgPen(x, Math.max(...sizes.map(size => size[1])));
  whole.parts = parts;
  return whole.text(title);
}
