// Mouse, fingers and keys on the live world.
import { $ } from './kit.js';
import { handleAt, view } from './plan.js';
import { change, FIRST, frameOf, go, live, move, MOVE_M, setPlaying, TURN_DEG, within, worlds } from './state.js';

export function near2(a, b) { return Math.hypot(a[0] - b[0], a[1] - b[1]); }
export function pointer(index) {
  const canvas = $('plan' + index);
  const spot = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  canvas.addEventListener('pointerdown', event => {
    const frame = frameOf(worlds[index]);
    if (!frame) return;
    const v = view(canvas, frame), p = spot(event);
    const toRobot = near2(p, [v.x(frame[0]), v.y(frame[1])]), toObstacle = near2(p, [v.x(frame[3]), v.y(frame[4])]);
    const toHandle = near2(p, handleAt(v, frame[3], frame[4], frame[5]));
    if (Math.min(toRobot, toObstacle, toHandle) > 40) return;
    const thing = toHandle < 14 && toHandle < toRobot ? 'handle' : toRobot <= toObstacle ? 'robot' : 'obstacle';
    live.held = { index, thing, v, turn: frame[5], at: thing === 'robot' ? [frame[0], frame[1]] : [frame[3], frame[4]] };
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add('holding');
  });
  canvas.addEventListener('pointermove', event => {
    const p = spot(event), frame = frameOf(worlds[index]);
    if (live.held && live.held.index === index) { if (live.held.thing === 'handle') live.held.turn = Math.atan2(p[0] - live.held.v.x(live.held.at[0]), p[1] - live.held.v.y(live.held.at[1])); else live.held.at = live.held.v.back(...p);
      live.held.moved = true; live.dirty = true; return; }
    if (!frame) return;
    const v = view(canvas, frame), n = live.catalogue.sonars;
    const angle = -Math.atan2(p[1] - v.y(frame[1]), p[0] - v.x(frame[0])) - frame[2];
    const next = near2(p, [v.x(frame[0]), v.y(frame[1])]) < Math.min(v.w, v.h) * 0.2
      ? ((Math.round(angle / (2 * Math.PI) * n) % n) + n) % n : -1;
    if (next !== live.chosen) { live.chosen = next; live.dirty = true; }
  });
  canvas.addEventListener('pointerleave', () => { live.chosen = -1; live.dirty = true; });
  const letGo = () => {
    const was = live.held;
    live.held = null;
    canvas.classList.remove('holding');
    if (was && was.moved) move(was.thing === 'handle' ? 'obstacle' : was.thing, was.at, was.turn);
  };
  canvas.addEventListener('pointerup', letGo);
  canvas.addEventListener('pointercancel', () => { live.held = null; live.dirty = true; });
  canvas.addEventListener('keydown', event => {
    const by = { ArrowLeft: [-MOVE_M, 0], ArrowRight: [MOVE_M, 0], ArrowUp: [0, -MOVE_M], ArrowDown: [0, MOVE_M] }[event.key];
    const frame = frameOf(worlds[index]);
    const turn = { '[': TURN_DEG, ']': -TURN_DEG }[event.key];
    if (turn && frame) {
      event.preventDefault();
      move('obstacle', [frame[3], frame[4]], within(frame[5] + turn * Math.PI / 180));
      return;
    }
    if (!by || !frame) return;
    event.preventDefault();
    const from = event.shiftKey ? [frame[3], frame[4]] : [frame[0], frame[1]];
    move(event.shiftKey ? 'obstacle' : 'robot', [from[0] + by[0], from[1] + by[1]], frame[5]);
  });
}
document.addEventListener('keydown', event => {
  if ($('live').hidden) return;
  if (/^(INPUT|SELECT|BUTTON|TEXTAREA)$/.test(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
  const act = { ' ': () => setPlaying(!live.playing), ',': () => go(Math.floor(live.now) - 1), '.': () => go(Math.floor(live.now) + 1), Home: () => go(0),
    c: () => { $('near').selectedIndex = ($('near').selectedIndex + 1) % 3; live.near = $('near').value; live.dirty = true; } }[event.key];
  if (act) { event.preventDefault(); act(); }
});
$('play').addEventListener('click', () => setPlaying(!live.playing));
$('back').addEventListener('click', () => go(Math.floor(live.now) - 1));
$('step').addEventListener('click', () => go(Math.floor(live.now) + 1));
$('scrub').addEventListener('input', () => go(Number($('scrub').value)));
$('near').addEventListener('change', () => { live.near = $('near').value; live.dirty = true; });
$('obstacle').addEventListener('change', () => { live.scene.obstacle = $('obstacle').value; live.now = 0; delete live.scene.start; live.scene.moves = []; change(0); });
$('sensor0').addEventListener('change', () => { live.scene.sensor = $('sensor0').value; change(0); });
$('sensor1').addEventListener('change', () => { live.beside = $('sensor1').value; change(0); });
$('sonar').addEventListener('change', () => { live.scene.sonar = $('sonar').value; change(0); });
$('robot').addEventListener('change', () => { live.scene.robot = $('robot').value; change(0); });
$('drive').addEventListener('change', () => { live.scene.speed_m_per_s = Number($('drive').value); live.now = 0; change(0); });
$('seed').addEventListener('change', () => { live.scene.seed = Number($('seed').value); change(0); });
$('reset').addEventListener('click', () => { delete live.scene.start; live.scene.moves = []; live.now = 0; change(0); });
$('copy').addEventListener('click', async () => {
  try { await navigator.clipboard.writeText($('line').textContent); $('linenote').textContent = 'Copied.'; }
  catch { getSelection().selectAllChildren($('line')); $('linenote').textContent = 'The line is selected: copy it with the keyboard.'; }
});
