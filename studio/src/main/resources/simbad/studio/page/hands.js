// Mouse, fingers and keys on the live world.
import { $ } from './kit.js';
import { handleAt, view } from './plan.js';
import { change, frameOf, go, live, move, MOVE_M, robotsOf, setPlaying, stepOf, TURN_DEG, within, worlds } from './state.js';

const GRAB_PX = 40, HANDLE_GRAB_PX = 14, MOST_ZOOM = 200;
const near2 = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
// What lies nearest to a point of the screen: a robot, the obstacle or what turns it; nothing where all are far.
function grabbed(p, v, frame) {
  const robots = robotsOf(frame).map((one, number) => ({ thing: 'robot', number, at: [one.x, one.z], far: near2(p, [v.x(one.x), v.y(one.z)]) }));
  const robot = robots.reduce((best, one) => one.far < best.far ? one : best);
  const at = [frame[3], frame[4]], toObstacle = near2(p, [v.x(at[0]), v.y(at[1])]), toHandle = near2(p, handleAt(v, ...at, frame[5]));
  if (Math.min(robot.far, toObstacle, toHandle) > GRAB_PX) return null;
  if (toHandle < HANDLE_GRAB_PX && toHandle < robot.far) return { thing: 'handle', at };
  return robot.far <= toObstacle ? robot : { thing: 'obstacle', at };
}
export function zoomBy(times, index, px, py) {
  const canvas = $('plan' + index), v = view(canvas, frameOf(worlds[index])), at = v.back(px ?? v.w / 2, py ?? v.h / 2);
  const zoom = Math.max(1, Math.min(MOST_ZOOM, live.zoom * times)), share = 1 - live.zoom / zoom;
  live.off = zoom === 1 ? [0, 0] : live.off.map((o, i) => o + (at[i] - v.centre[i]) * share);
  live.zoom = zoom;
  live.dirty = true;
}
function showAll() { live.zoom = 1; live.off = [0, 0]; live.dirty = true; }
function chooseRobot(number) {
  if (number === undefined) return;
  live.robot = number;
  $('which').value = String(number);
}
// Which sonar of the chosen robot looks at a point near it.
function sonarAt(p, v, frame) {
  const { x, z, heading } = robotsOf(frame)[live.robot], n = live.catalogue.sonars;
  if (near2(p, [v.x(x), v.y(z)]) >= Math.min(v.w, v.h) * 0.2) return -1;
  const angle = -Math.atan2(p[1] - v.y(z), p[0] - v.x(x)) - heading;
  return ((Math.round(angle / (2 * Math.PI) * n) % n) + n) % n;
}
export function pointer(index) {
  const canvas = $('plan' + index), world = worlds[index];
  const spot = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  let pulled = null;
  canvas.addEventListener('pointerdown', event => {
    const frame = frameOf(world);
    if (!frame) return;
    const v = view(canvas, frame), p = spot(event), found = grabbed(p, v, frame);
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add('holding');
    if (!found) { pulled = p; return; }
    chooseRobot(found.number);
    // What is shown is what is moved: of the steps that were left out nobody has seen any.
    live.now = stepOf(world);
    live.held = { ...found, index, v, turn: frame[5], from: p };
  });
  canvas.addEventListener('pointermove', event => {
    const p = spot(event), frame = frameOf(world), held = live.held;
    if (held && held.index === index) {
      if (held.thing === 'handle') held.turn = Math.atan2(p[0] - held.v.x(held.at[0]), p[1] - held.v.y(held.at[1]));
      else held.at = held.v.back(...p);
      held.moved ||= near2(p, held.from) > 2;
      live.dirty = true;
      return;
    }
    if (!frame) return;
    const v = view(canvas, frame);
    if (pulled) {
      live.off = [0, 1].map(i => live.off[i] - (p[i] - pulled[i]) / v.scale);
      pulled = p;
      live.dirty = true;
      return;
    }
    const next = sonarAt(p, v, frame);
    if (next !== live.chosen) { live.chosen = next; live.dirty = true; }
  });
  canvas.addEventListener('pointerleave', () => { live.chosen = -1; live.dirty = true; });
  const letGo = () => {
    const was = live.held;
    pulled = null;
    canvas.classList.remove('holding');
    if (!was || was.index !== index) return;
    live.held = null;
    live.dirty = true;
    if (was.moved) move(was.thing === 'handle' ? 'obstacle' : was.thing, was.at, was.turn, was.number);
  };
  canvas.addEventListener('pointerup', letGo);
  canvas.addEventListener('pointercancel', () => { live.held = null; pulled = null; live.dirty = true; });
  canvas.addEventListener('dblclick', showAll);
  canvas.addEventListener('wheel', event => {
    // The page scrolls until somebody has taken the plan in hand.
    if (!event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 400), index, ...spot(event));
  }, { passive: false });
  canvas.addEventListener('keydown', event => keyOnPlan(event, index));
}
function keyOnPlan(event, index) {
  const frame = frameOf(worlds[index]);
  if (!frame || event.ctrlKey || event.metaKey || event.altKey) return;
  const by = { ArrowLeft: [-MOVE_M, 0], ArrowRight: [MOVE_M, 0], ArrowUp: [0, -MOVE_M], ArrowDown: [0, MOVE_M] }[event.key], turn = { '[': TURN_DEG, ']': -TURN_DEG }[event.key];
  const look = { '+': () => zoomBy(1.25, index), '-': () => zoomBy(0.8, index), 0: showAll }[event.key];
  if (!by && !turn && !look) return;
  event.preventDefault();
  if (look) return look();
  live.now = stepOf(worlds[index]);
  if (turn) return move('obstacle', [frame[3], frame[4]], within(frame[5] + turn * Math.PI / 180));
  const robot = robotsOf(frame)[live.robot], from = event.shiftKey ? [frame[3], frame[4]] : [robot.x, robot.z];
  move(event.shiftKey ? 'obstacle' : 'robot', [from[0] + by[0], from[1] + by[1]], frame[5], event.shiftKey ? 0 : live.robot);
}
document.addEventListener('keydown', event => {
  if ($('live').hidden) return;
  if (/^(INPUT|SELECT|BUTTON|TEXTAREA)$/.test(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
  const act = { ' ': () => setPlaying(!live.playing), ',': () => go(Math.floor(live.now) - 1), '.': () => go(Math.floor(live.now) + 1), Home: () => go(0),
    c: () => { $('near').selectedIndex = ($('near').selectedIndex + 1) % 3; looksAt(); } }[event.key];
  if (act) { event.preventDefault(); act(); }
});
function looksAt() { live.near = $('near').value; showAll(); }
$('play').addEventListener('click', () => setPlaying(!live.playing));
$('back').addEventListener('click', () => go(Math.floor(live.now) - 1));
$('step').addEventListener('click', () => go(Math.floor(live.now) + 1));
$('scrub').addEventListener('input', () => go(Number($('scrub').value)));
$('near').addEventListener('change', looksAt);
$('closer').addEventListener('click', () => zoomBy(1.5, 0));
$('wider').addEventListener('click', () => zoomBy(1 / 1.5, 0));
$('which').addEventListener('change', () => { live.robot = Number($('which').value); live.dirty = true; });
$('obstacle').addEventListener('change', () => { live.scene.obstacle = $('obstacle').value; live.now = 0; delete live.scene.start; live.scene.moves = []; change(0); });
$('sensor0').addEventListener('change', () => { live.scene.sensor = $('sensor0').value; change(0); });
$('sensor1').addEventListener('change', () => { live.beside = $('sensor1').value; change(0); });
$('sonar').addEventListener('change', () => { live.scene.sonar = $('sonar').value; change(0); });
$('robot').addEventListener('change', () => { live.scene.robot = $('robot').value; change(0); });
$('robot1').addEventListener('change', () => { live.besideRobot = $('robot1').value; change(0); });
$('robots').addEventListener('change', () => { live.scene.robots = Number($('robots').value); live.now = 0; delete live.scene.start; live.scene.moves = []; change(0); });
$('drive').addEventListener('change', () => { live.scene.speed_m_per_s = Number($('drive').value); live.now = 0; change(0); });
$('seed').addEventListener('change', () => { live.scene.seed = Number($('seed').value); change(0); });
$('reset').addEventListener('click', () => { delete live.scene.start; live.scene.moves = []; live.now = 0; change(0); });
$('copy').addEventListener('click', async () => {
  try { await navigator.clipboard.writeText($('line').textContent); $('linenote').textContent = 'Copied.'; }
  catch { getSelection().selectAllChildren($('line')); $('linenote').textContent = 'The line is selected: copy it with the keyboard.'; }
});
