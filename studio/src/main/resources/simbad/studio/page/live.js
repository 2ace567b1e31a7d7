// The live world's page: begins, and goes on with every frame of the screen.
import { $, ask, fault, still } from './kit.js';
import { pointer } from './hands.js';
import { draw, isTiny, readColours, view } from './plan.js';
import { opened } from './scene-files.js';
import { active, change, endStep, fetchAhead, frameOf, isOriginal, live, loudness, most, AS_TOLD, robotIn, robotsOf, setPlaying, worlds } from './state.js';
import { fields, rows } from './words.js';

let begun = false;
// Begins when it is first looked at.
export function wake() {
  live.dirty = true;
  if (begun) return;
  begun = true;
  begin();
  requestAnimationFrame(tick);
}
// A picture 30 times a second looks smooth; words and numbers that change oftener nobody can read.
// The screen's frames come a little early or late, or not at all: the time of the next picture follows from the one before, not from when that was drawn.
const BETWEEN_PICTURES_MS = 1000 / 30, EARLY_MS = 4, BETWEEN_WORDS_MS = 100;
function tick(time) {
  const passed = Math.min(0.1, (time - live.before) / 1000);
  live.before = time;
  if (live.catalogue && !$('live').hidden) {
    if (live.playing && !live.held) {
      live.now = Math.min(most(), endStep(), live.now + passed / live.catalogue.step_s * Number($('speed').value));
      if (live.now >= endStep()) setPlaying(false);
      live.dirty = true;
    }
    if (live.wish > live.now) { live.now = Math.min(most(), live.wish); live.dirty = true; }
    active().forEach(fetchAhead);
    if (live.dirty && time >= live.due - EARLY_MS) {
      live.due = Math.max(live.due + BETWEEN_PICTURES_MS, time);
      active().forEach((world, i) => draw(i));
      live.dirty = false;
      if (live.playing && time - live.told < BETWEEN_WORDS_MS) live.untold = true; else tell(time);
    } else if (live.untold && time - live.told >= BETWEEN_WORDS_MS) tell(time);
  }
  requestAnimationFrame(tick);
}
function tell(time) {
  live.told = time;
  live.untold = false;
  active().forEach((world, i) => {
    const frame = frameOf(world), n = live.catalogue.sonars, all = n * live.scene.robots;
    const heard = frame ? robotsOf(frame).reduce((sum, one) => sum + frame.slice(one.at, one.at + n).filter(r => r >= 0).length, 0) : 0;
    $('name' + i).textContent = world.sensor + (robotIn(i) ? ', moves as ' + robotIn(i) : '');
    const more = document.createElement('span');
    more.textContent = frame ? ' \u00b7 ' + heard + ' of ' + all + ' hear' : ' \u00b7 waiting';
    $('name' + i).append(more);
  });
  rows();
  $('scrub').max = endStep();
  $('scrub').value = Math.max(live.wish, Math.floor(live.now));
  $('ringed').hidden = !isTiny(view($('plan0'), frameOf(worlds[0])));
  $('louder').hidden = !active().some(world => loudness(world.sensor).length);
  $('limit').hidden = !active().some(isOriginal);
  const seconds = (Math.floor(live.now) * live.catalogue.step_s).toFixed(2) + ' s';
  $('scrub').setAttribute('aria-valuetext', seconds);
  $('clock').textContent = seconds + ' \u00b7 step ' + Math.floor(live.now);
}
function choose(id, names, first) {
  $(id).replaceChildren(...names.map(name => new Option(name || first, name)));
}
async function begin() {
  readColours();
  try { live.catalogue = await ask('/catalogue'); } catch (e) { fault('NOT LIVE: ' + e.message); return; }
  const sensors = live.catalogue.sensors.map(s => s.name);
  choose('obstacle', live.catalogue.obstacles.map(o => o.name));
  choose('sensor0', sensors);
  choose('sonar', live.catalogue.transducers.map(one => one.name));
  choose('robot', ['', ...live.catalogue.robots.map(one => one.name)], 'exactly as told');
  $('robot1').replaceChildren(new Option('as the first', ''), new Option('exactly as told', AS_TOLD), ...live.catalogue.robots.map(one => new Option(one.name)));
  choose('sensor1', ['', ...sensors], 'nothing');
  choose('robots', Array.from({ length: live.catalogue.most_robots }, (_, i) => String(i + 1)));
  live.scene.obstacle = live.catalogue.obstacles.some(o => o.name === 'angle') ? 'angle' : live.catalogue.obstacles[0].name;
  live.scene.sensor = sensors[0];
  for (let i = 0; i < live.catalogue.sonars; i++) {
    const row = $('rows').insertRow(), to = 360 * i / live.catalogue.sonars;
    row.insertCell().textContent = to === 0 ? 'ahead' : to === 180 ? 'behind' : to < 180 ? 'left ' + to + '\u00b0' : 'right ' + (360 - to) + '\u00b0';
    row.insertCell(); row.insertCell();
    row.cells[0].className = row.cells[1].className = 'r';
    row.addEventListener('pointerenter', () => { live.chosen = i; live.dirty = true; });
    row.addEventListener('pointerleave', () => { live.chosen = -1; live.dirty = true; });
  }
  fields();
  change(0);
  if (live.catalogue.scene) try { opened(live.catalogue.scene); } catch (e) { fault('--scene: ' + e.message); }
  pointer(0); pointer(1);
  setPlaying(!still);
}
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', readColours);
new ResizeObserver(() => { live.dirty = true; }).observe($('views'));
