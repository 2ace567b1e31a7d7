// Plots answer to mouse, touch and keys. Without this script the page is whole: it only adds.
'use strict';
{
const MOST = 16, STEP = 1.5, NEAR = 14;
const NS = 'http://www.w3.org/2000/svg';
const HINT = 'Point at it, or go here with Tab and use the arrow keys.';
const HOW = 'Arrow keys read its values, plus and minus zoom, Shift with an arrow moves it, 0 shows all.';
const INK = ['color', 'fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-opacity', 'stroke-dasharray', 'stroke-linecap',
  'stroke-linejoin', 'opacity', 'vector-effect', 'font-size', 'font-family', 'font-weight', 'text-anchor', 'dominant-baseline'];
const numbers = text => text.split(' ').map(Number);
const known = (parent, tag, more) => parent.appendChild(Object.assign(document.createElement(tag), more));

/** What a row of a table says: each cell behind its column's title. */
function words(row) {
  const titles = [...row.closest('table').tHead.rows[0].cells].map(cell => cell.textContent);
  return [...row.cells].map((cell, i) => titles[i] + ' ' + cell.textContent).join(', ');
}

/** Rows of a table that lie along an axis or round a centre. */
function rows(svg) {
  const data = svg.dataset;
  return [...document.getElementById(data.rows).tBodies[0].rows].map(row => {
    const value = parseFloat(row.cells[0].textContent.replace('\u2212', '-'));
    if (data.centre) {
      const [x, y] = numbers(data.centre), turn = value * Math.PI / 180, r = Number(data.radius);
      const end = [x + r * Math.sin(turn), y + r * Math.cos(turn)];
      return {x: end[0], y: end[1], turn, text: words(row), d: `M${x} ${y}L${end[0]} ${end[1]}`};
    }
    const [a, from] = numbers(data.from), [b, to] = numbers(data.to);
    const x = a + (b - a) * (value - from) / (to - from), all = svg.viewBox.baseVal;
    return {x, y: all.height / 2, text: words(row), d: `M${x} 4V${all.height - 4}`};
  });
}

/** Cells round a centre, ring by ring, from their numbers. */
function cells(svg) {
  const data = svg.dataset, [x, y] = numbers(data.centre), width = Number(data.ring), m = Number(data.metres);
  return data.cells.split(';').flatMap((ring, r) => ring.split(',').map((value, s, all) => {
    const deg = 360 * s / all.length, turn = deg * Math.PI / 180, middle = (r + .5) * width;
    const digits = Math.max(0, Math.ceil(-Math.log10(m) - 1e-9));
    const at = {x: x + middle * Math.sin(turn), y: y + middle * Math.cos(turn), turn, r, s, value};
    return {...at, half: Math.PI / all.length + 1e-6, d: `M${at.x - 4} ${at.y}h8m-4 -4v8`,
      text: `bearing ${deg}°, ${(r * m).toFixed(digits)} to ${((r + 1) * m).toFixed(digits)} m: ${value} cm`};
  })).filter(cell => cell.value !== '');
}

/** Shapes that have a tip. */
function shapes(svg, spot) {
  return [...svg.querySelectorAll('* > title')].map(title => {
    const shape = title.parentNode, box = shape.getBoundingClientRect();
    return {...spot(box.left + box.width / 2, box.top + box.height / 2), shape, text: title.textContent};
  });
}

/** Cells as a spreadsheet reads them. */
function csv(table) {
  const field = text => /[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
  const line = row => [...row.cells].map(cell => field(cell.textContent.trim().replace('\u2212', '-'))).join(',');
  return [...table.rows].map(line).join('\n') + '\n';
}
/** The numbers of a plot: its table, or what its marks say. */
function figures(svg, marks) {
  if (svg.dataset.rows) return csv(document.getElementById(svg.dataset.rows));
  if (svg.dataset.cells) return 'bearing_deg,ring,cm\n' + marks.map(m => [Math.round(m.turn * 1800 / Math.PI) / 10, m.r + 1, m.value].join(',')).join('\n') + '\n';
  return 'shown\n' + marks.map(mark => '"' + mark.text.replaceAll('"', '""') + '"').join('\n') + '\n';
}
/** A drawing as a file of its own, as it is shown: what the style sheet says of it stands in it. */
function drawn(svg) {
  const copy = svg.cloneNode(true), from = [svg, ...svg.querySelectorAll('*')], to = [copy, ...copy.querySelectorAll('*')];
  from.forEach((shape, i) => {
    const css = getComputedStyle(shape);
    to[i].removeAttribute('class');
    for (const name of INK) to[i].style.setProperty(name, css.getPropertyValue(name));
  });
  for (const name of Object.keys(copy.dataset)) delete copy.dataset[name];
  const box = svg.getBoundingClientRect();
  copy.setAttribute('xmlns', NS);
  copy.setAttribute('width', Math.round(box.width));
  copy.setAttribute('height', Math.round(box.height));
  copy.style.background = getComputedStyle(svg.closest('figure')).backgroundColor;
  return new XMLSerializer().serializeToString(copy) + '\n';
}
function save(name, end, text, type) {
  const link = Object.assign(document.createElement('a'), {href: URL.createObjectURL(new Blob([text], {type}))});
  link.download = (name.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'table').slice(0, 60) + end;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function view(svg) {
  const name = svg.getAttribute('aria-label');
  const box = Object.assign(document.createElement('div'), {className: 'view', tabIndex: 0});
  box.setAttribute('role', 'application');
  box.setAttribute('aria-label', name + '. ' + HOW);
  svg.before(box);
  box.append(svg);
  const tools = Object.assign(document.createElement('div'), {className: 'tools'});
  box.after(tools);
  const out = known(tools, 'output', {textContent: HINT});
  const button = (sign, what, click) =>
    known(tools, 'button', {type: 'button', textContent: sign, onclick: click}).setAttribute('aria-label', what + name);
  const {width, height} = svg.viewBox.baseVal;
  const now = {x: 0, y: 0, zoom: 1};
  let marks = null, at = -1, cursor = null, drag = null;

  const spot = (clientX, clientY) => {
    const p = new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());
    return {x: p.x, y: p.y};
  };
  function all() {
    marks ??= svg.dataset.rows ? rows(svg) : svg.dataset.cells ? cells(svg) : shapes(svg, spot);
    return marks;
  }
  function show(zoom, x, y) {
    now.zoom = Math.min(MOST, Math.max(1, zoom));
    const w = width / now.zoom, h = height / now.zoom;
    now.x = Math.min(width - w, Math.max(0, x));
    now.y = Math.min(height - h, Math.max(0, y));
    svg.setAttribute('viewBox', [now.x, now.y, w, h].map(n => +n.toFixed(3)).join(' '));
    svg.style.setProperty('--zoom', now.zoom);
    box.classList.toggle('near', now.zoom > 1);
  }
  /** The place that is held stays where it is. */
  function zoom(factor, held) {
    const next = Math.min(MOST, Math.max(1, now.zoom * factor)), share = now.zoom / next;
    show(next, held.x - (held.x - now.x) * share, held.y - (held.y - now.y) * share);
  }
  const middle = () => ({x: now.x + width / now.zoom / 2, y: now.y + height / now.zoom / 2});
  const whole = () => show(1, 0, 0);
  function move(dx, dy) { show(now.zoom, now.x + dx * width / now.zoom, now.y + dy * height / now.zoom); }

  function read(index) {
    const before = all()[at];
    if (before && before.shape) before.shape.classList.remove('lit');
    cursor?.remove();
    cursor = null;
    at = index;
    const mark = marks[at];
    out.textContent = mark ? mark.text : HINT;
    if (!mark) return;
    if (mark.shape) mark.shape.classList.add('lit');
    if (!mark.d) return;
    cursor = svg.appendChild(document.createElementNS(NS, 'path'));
    cursor.setAttribute('class', 'cursor');
    cursor.setAttribute('d', mark.d);
  }
  /** Keys read what is in sight. */
  function visit(index) {
    if (index < 0) return;
    read(index);
    const {x, y} = marks[index], w = width / now.zoom, h = height / now.zoom;
    if (x < now.x || x > now.x + w || y < now.y || y > now.y + h) show(now.zoom, x - w / 2, y - h / 2);
  }
  /** The nearest mark that way; a table has but one way to go. */
  function next(dx, dy) {
    const here = all()[at];
    if (!here) return marks.length > 0 ? 0 : -1;
    if (svg.dataset.rows) return Math.min(marks.length - 1, Math.max(0, at + (dx || -dy)));
    let best = -1, least = Infinity;
    marks.forEach((mark, i) => {
      const along = (mark.x - here.x) * dx + (mark.y - here.y) * dy;
      const across = Math.abs((mark.x - here.x) * dy) + Math.abs((mark.y - here.y) * dx);
      if (i !== at && along > .01 && along + 3 * across < least) { least = along + 3 * across; best = i; }
    });
    return best < 0 ? at : best;
  }
  function under(event) {
    const p = spot(event.clientX, event.clientY), data = svg.dataset;
    if (!data.rows && !data.cells) {
      const shape = event.target.closest?.('svg *');
      const hit = all().findIndex(mark => mark.shape === shape);
      if (hit >= 0) return hit;
    }
    const [cx, cy] = data.centre ? numbers(data.centre) : [0, 0];
    const turn = Math.atan2(p.x - cx, p.y - cy);
    const apart = mark => Math.abs(Math.atan2(Math.sin(mark.turn - turn), Math.cos(mark.turn - turn)));
    const far = data.cells
      ? mark => mark.r === Math.floor(Math.hypot(p.x - cx, p.y - cy) / data.ring) && apart(mark) < mark.half ? 0 : Infinity
      : data.rows && data.centre ? apart
      : data.rows ? mark => Math.abs(mark.x - p.x) / width
      : mark => Math.hypot(mark.x - p.x, mark.y - p.y) * now.zoom / NEAR;
    let best = -1, least = data.rows ? Infinity : 1;
    all().forEach((mark, i) => { const d = far(mark); if (d < least) { least = d; best = i; } });
    return best;
  }

  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  box.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) move(arrow[0] / 5, arrow[1] / 5);
    else if (arrow) visit(next(...arrow));
    else if (event.key === 'Home') visit(all().length ? 0 : -1);
    else if (event.key === 'End') visit(all().length - 1);
    else if (event.key === '+' || event.key === '=') zoom(STEP, marks?.[at] ?? middle());
    else if (event.key === '-') zoom(1 / STEP, middle());
    else if (event.key === '0') whole();
    else if (event.key === 'Escape') { whole(); read(-1); }
    else return;
    event.preventDefault();
  });
  box.addEventListener('wheel', event => {
    const closer = event.deltaY < 0, can = closer ? now.zoom < MOST : now.zoom > 1;
    // The page scrolls on over plots that nobody has taken hold of.
    if (!can || !(event.ctrlKey || document.activeElement === box)) return;
    event.preventDefault();
    zoom(closer ? 1.2 : 1 / 1.2, spot(event.clientX, event.clientY));
  }, {passive: false});
  box.addEventListener('pointerdown', event => { drag = now.zoom > 1 && event.isPrimary ? event : null; });
  box.addEventListener('pointermove', event => {
    if (!drag) { read(under(event)); return; }
    const scale = width / now.zoom / svg.clientWidth;
    show(now.zoom, now.x - (event.clientX - drag.clientX) * scale, now.y - (event.clientY - drag.clientY) * scale);
    drag = event;
  });
  for (const end of ['pointerup', 'pointercancel', 'pointerleave']) box.addEventListener(end, () => { drag = null; });
  box.addEventListener('pointerleave', () => { if (document.activeElement !== box) read(-1); });
  box.addEventListener('dblclick', whole);
  button('+', 'Zoom in: ', () => zoom(STEP, middle()));
  button('\u2212', 'Zoom out: ', () => zoom(1 / STEP, middle()));
  button('All', 'Show all: ', whole);
  button('SVG', 'Save as SVG: ', () => { read(-1); save(name, '.svg', drawn(svg), 'image/svg+xml'); });
  button('csv', 'Save numbers as csv: ', () => save(name, '.csv', figures(svg, all()), 'text/csv'));
  addEventListener('beforeprint', whole);
}

function savable(table) {
  const name = table.caption?.textContent ?? table.closest('details')?.querySelector('summary').textContent ?? document.title;
  const tools = Object.assign(document.createElement('div'), {className: 'tools'});
  table.closest('.scroll').after(tools);
  known(tools, 'button', {type: 'button', textContent: 'csv', onclick: () => save(name, '.csv', csv(table), 'text/csv')})
    .setAttribute('aria-label', 'Save table as csv: ' + name);
}

/** Bars as rows: name, what is the whole length, what of it is filled, value in words. */
function barRows(box) {
  if (box.classList.contains('budget')) {
    const said = [...box.nextElementSibling.querySelectorAll('.key')].map(key => key.nextSibling.textContent.replace(/^\u00a0|; $/g, ''));
    return [...box.children].map((part, i) => ({name: '', whole: box, parts: [part], value: said[i]}));
  }
  return [...box.querySelectorAll('.track')].map(track => ({name: track.previousElementSibling.textContent, whole: track,
    parts: [...track.children], value: track.nextElementSibling.textContent}));
}
/** The same bars as a drawing. */
function barred(rows, title) {
  const css = getComputedStyle(document.body), long = Math.max(...rows.map(row => row.value.length));
  const width = 630 + 8 * long, height = 50 + 28 * rows.length;
  const put = (x, y, text) => `<text x="${x}" y="${y}" fill="${css.color}">${text.replaceAll('&', '&amp;').replaceAll('<', '&lt;')}</text>`;
  const shapes = rows.map(({name, whole, parts, value}, i) => {
    const all = whole.getBoundingClientRect(), y = 40 + 28 * i;
    const rect = part => {
      const at = part.getBoundingClientRect(), px = n => (400 * n / all.width).toFixed(1), high = 18 * at.height / all.height;
      return `<rect x="${200 + Number(px(at.left - all.left))}" y="${y + 9 - high / 2}" width="${px(at.width)}" height="${high}" fill="${getComputedStyle(part).backgroundColor}"/>`;
    };
    return put(10, y + 14, name) + `<rect x="200" y="${y}" width="400" height="18" fill="#8883"/>` + parts.map(rect).join('') + put(610, y + 14, value);
  });
  return `<svg xmlns="${NS}" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="14" style="background:${css.backgroundColor}">`
    + put(10, 22, title) + shapes.join('') + '</svg>\n';
}
function bars(box) {
  const rows = barRows(box);
  const title = (box.classList.contains('budget') ? box.previousElementSibling : box.closest('section').querySelector('h3')).textContent;
  const tools = Object.assign(document.createElement('div'), {className: 'tools'});
  box.after(tools);
  const quoted = text => '"' + text.trim().replaceAll('\u2212', '-').replaceAll('"', '""') + '"';
  const numbers = () => rows.map(row => [row.name, row.value].filter(Boolean).map(quoted).join(',')).join('\n') + '\n';
  const button = (sign, what, click) =>
    known(tools, 'button', {type: 'button', textContent: sign, onclick: click}).setAttribute('aria-label', what + title);
  button('SVG', 'Save as SVG: ', () => save(title, '.svg', barred(rows, title), 'image/svg+xml'));
  button('csv', 'Save numbers as csv: ', () => save(title, '.csv', numbers(), 'text/csv'));
}

for (const svg of document.querySelectorAll('figure > svg')) view(svg);
for (const box of document.querySelectorAll('.panel > .bars, .panel > .budget')) bars(box);
for (const table of document.querySelectorAll('.scroll > table')) savable(table);

// Paper cannot be opened.
let opened = [];
addEventListener('beforeprint', () => {
  opened = [...document.querySelectorAll('details:not([open])')];
  opened.forEach(details => { details.open = true; });
});
addEventListener('afterprint', () => opened.forEach(details => { details.open = false; }));
}
