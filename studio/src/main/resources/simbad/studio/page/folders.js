// Folders: the list, and the one that is open, perhaps beside another.
import { $, ask, el, fault } from './kit.js';
import { showBatch } from './batch.js';
import { showCapture } from './capture.js';
import { showJoint } from './joint.js';
import { showMotion } from './motion.js';
import { showRun } from './run.js';
import { showSensing } from './sensing.js';

const SHOWN = { run: showRun, batch: showBatch, sensing: showSensing, motion: showMotion, joint: showJoint, capture: showCapture };
const KINDS = { run: 'run', batch: 'batch', sensing: 'diagnosis of sensing', motion: 'diagnosis of motion', joint: 'diagnosis of a joint log', capture: 'capture' };
let list = null, close = () => {}, asked = 0, again = null;
const link = (path, beside) => '#' + new URLSearchParams(beside ? { open: path, with: beside } : { open: path });

export async function showFolders(open, beside) {
  const mine = ++asked;
  again = null;
  try {
    list = await ask('/folders');
    if (list.fault) throw new Error(list.fault);
    if (mine !== asked) return;
    if (!list.folders) return put(el('section', {}, el('h2', {}, 'No folder'), el('p', {}, 'The studio was started without one. ', el('code', {}, './simbad studio FOLDER'), ' shows what lies in it.')));
    if (!open) return put(listed());
    put(el('p', { role: 'status' }, 'Reading ' + open + ' \u2026'));
    const answers = await Promise.all([open, beside].filter(Boolean).map(path => ask('/folder', { path })));
    if (mine !== asked) return;
    for (const answer of answers) if (answer.fault) throw new Error(answer.fault);
    fault('');
    again = () => {
      const kind = answers[0].kind, page = el('div', { class: 'opened' });
      put(el('div', {}, head(answers[0], beside), page));
      close = SHOWN[kind](page, answers[0], answers[1]) || (() => {});
    };
    again();
  } catch (e) {
    if (mine !== asked) return;
    put(el('p', {}, el('a', { href: '#folders' }, 'All folders')));
    fault(e.message.includes('fetch') ? 'NOT LIVE: ' + e.message + '. Is ./simbad studio still running?' : e.message);
  }
}
function put(element) {
  close();
  close = () => {};
  fault('');
  $('folders').replaceChildren(element);
}
function listed() {
  const rows = el('tbody'), search = el('input', { type: 'search', oninput: () => fill() });
  const fill = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = list.folders.filter(one => words.every(word => (one.path + ' ' + KINDS[one.kind] + ' ' + one.about).toLowerCase().includes(word)));
    rows.replaceChildren(...found.map(one => el('tr', {}, el('td', {}, el('a', { href: link(one.path) }, one.path === '.' ? list.folder : one.path)), el('td', {}, KINDS[one.kind]), el('td', {}, one.about))));
    said.textContent = found.length + ' of ' + list.folders.length + (list.more ? ' (the first ones: there are more)' : '');
  };
  const said = el('p', { class: 'note', role: 'status' });
  const section = el('section', {}, el('h2', {}, 'In ' + list.folder), el('label', { class: 'search' }, 'Search by name, kind, obstacle, verdict', search), said,
    el('div', { class: 'scroll' }, el('table', {}, el('thead', {}, el('tr', {}, ['Folder', 'What it is', 'Of'].map(name => el('th', { scope: 'col' }, name)))), rows)));
  fill();
  return section;
}
function head(answer, beside) {
  const others = list.folders.filter(one => one.kind === answer.kind && one.path !== answer.path);
  const choice = el('select', { onchange: event => { location.hash = link(answer.path, event.target.value); } },
    ['', ...others.map(one => one.path)].map(path => el('option', { value: path, selected: path === (beside || '') }, path || 'nothing')));
  return el('div', { class: 'openhead' }, el('a', { href: '#folders' }, 'All folders'), el('h2', {}, (answer.path === '.' ? list.folder : answer.path) + ' \u00b7 ' + KINDS[answer.kind]),
    others.length ? el('label', {}, 'Compare with', choice) : null);
}
// Colours on canvases are the theme's of when they were drawn.
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { if (again) again(); });
