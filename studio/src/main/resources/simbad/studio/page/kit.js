// What every page of the studio needs: asking, saying, saving.
export const $ = id => document.getElementById(id);
export const still = matchMedia('(prefers-reduced-motion: reduce)').matches;

// The page's address holds the token: who asks sends it along.
export async function ask(path, body) {
  const answer = await fetch(path + location.search, body ? { method: 'POST', body: JSON.stringify(body) } : {});
  if (!answer.ok) throw new Error('the studio answers ' + answer.status);
  return answer.json();
}
export function fault(text) { $('fault').textContent = text; }
export function escaped(text) { return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;'); }
export function give(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
// Colours of the theme as the browser has them, by their names in kit.css.
export function themeColours(names) {
  const css = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map(name => [name, css.getPropertyValue('--' + name).trim()]));
}
// An element with text in it: whatever a file says stays text.
export function el(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, '');
    else if (value !== false && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children.flat().filter(child => child !== undefined && child !== null));
  return made;
}
// The key of a line in a legend: its colour and its very dashes, which tell lines apart where colours do not.
export function lineKey(colour, dashes = []) {
  const SVG = 'http://www.w3.org/2000/svg', picture = document.createElementNS(SVG, 'svg'), line = document.createElementNS(SVG, 'line');
  for (const [key, value] of Object.entries({ class: 'linekey key-' + colour, width: 34, height: 8, 'aria-hidden': 'true' })) picture.setAttribute(key, value);
  for (const [key, value] of Object.entries({ x1: 0, x2: 34, y1: 4, y2: 4, 'stroke-width': 3, stroke: 'currentColor', 'stroke-dasharray': dashes.join(' ') })) line.setAttribute(key, value);
  picture.append(line);
  return picture;
}
export function number(value, decimals) {
  return value === null || value === undefined || !Number.isFinite(value) ? '\u2013' : value.toFixed(decimals).replace('-', '\u2212');
}
// Rows of texts and numbers as a table; what starts with # is a number and stands right.
export function table(caption, heads, rows) {
  const right = heads.map(head => head.startsWith('#'));
  const cell = (content, i) => el('td', right[i] ? { class: 'r' } : {}, content);
  return el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': caption },
    el('table', {}, el('thead', {}, el('tr', {}, heads.map((head, i) => el('th', { scope: 'col', class: right[i] ? 'r' : '' }, head.replace(/^#/, ''))))),
      el('tbody', {}, rows.map(row => el('tr', {}, row.map(cell))))));
}
export function csvText(heads, rows) {
  const field = value => value === null || value === undefined ? '' : /[",\n\r]/.test(value) ? '"' + String(value).replaceAll('"', '""') + '"' : String(value);
  return [heads, ...rows].map(row => row.map(field).join(',')).join('\n') + '\n';
}
export function giveText(name, text, type) { give(name, new Blob([text], { type })); }
// A drawing of the page as a file of its own: what style sheets say of it stands in it.
const INK = ['paint-order', 'fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'font-size', 'font-family', 'font-weight', 'text-anchor', 'dominant-baseline'];
export function savedSvg(svg) {
  const whole = svg.cloneNode(true), from = [svg, ...svg.querySelectorAll('*')], to = [whole, ...whole.querySelectorAll('*')], box = svg.getBoundingClientRect();
  from.forEach((one, i) => { const css = getComputedStyle(one); to[i].removeAttribute('class'); for (const name of INK) to[i].style.setProperty(name, css.getPropertyValue(name)); });
  whole.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  whole.setAttribute('width', Math.round(box.width)); whole.setAttribute('height', Math.round(box.height));
  whole.style.background = getComputedStyle(document.body).backgroundColor;
  return new XMLSerializer().serializeToString(whole) + '\n';
}
