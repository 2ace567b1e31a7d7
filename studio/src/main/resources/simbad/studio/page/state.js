// The live world: what is asked for, what is known of it, where in time the page is.
import { $, ask, fault } from './kit.js';
import { words } from './words.js';

export const FORMAT = 'simbad-studio/1', MOVE_M = 0.05, TURN_DEG = 5, HANDLE_PX = 34, RING_PX = 9, FIRST = 6;
// While it plays, frames are asked for so often, and no trail is coarser than this.
const FRAMES_PER_S = 30, TRAIL_M = 0.01, FAR_STEPS = 2000, AROUND = 50;
export const live = {
  catalogue: null, colours: {}, beside: '', besideRobot: '', now: 0, playing: false, before: 0, due: 0, told: 0, near: '', zoom: 1, off: [0, 0], robot: 0, chosen: -1, edition: 0,
  held: null, dirty: true, wish: 0,
  scene: { format: FORMAT, obstacle: '', sensor: '', sonar: 'srf04', robot: '', robots: 1, speed_m_per_s: 0.01, seed: 1, moves: [] },
};
// Of frames some are left out where the world ran fast: known has the steps of those that are there, upTo is the first step that nobody has asked for yet.
export const worlds = [0, 1].map(() => ({ frames: [], known: [], upTo: 0, asking: false, sensor: '', moved: null }));
// How the robots of either view move: the second view's as those of the first, if nothing else is said.
export const AS_TOLD = '*';
export const robotIn = index => index === 0 || live.besideRobot === '' ? live.scene.robot : live.besideRobot === AS_TOLD ? '' : live.besideRobot;
const sceneOf = world => ({ ...live.scene, sensor: world.sensor, robot: robotIn(worlds.indexOf(world)) });
export const active = () => live.beside ? worlds : worlds.slice(0, 1);
export const typeNow = () => live.catalogue.obstacles.find(o => o.name === live.scene.obstacle);
export const sensorOf = name => live.catalogue.sensors.find(s => s.name === name);
export const robotOf = name => live.catalogue.robots.find(r => r.name === name);
// Half of the cone: a diagnosed sensor's own, else that of the sonar.
export const halfAngle = name => (sensorOf(name).half_angle_deg ?? live.catalogue.transducers.find(one => one.name === live.scene.sonar).half_angle_deg) * Math.PI / 180;
export const isOriginal = world => /^(original|ray)$/.test(world.sensor);
export const turned = ([x, z], turn) => [x * Math.cos(turn) + z * Math.sin(turn), z * Math.cos(turn) - x * Math.sin(turn)];
const robotAt = i => i === 0 ? 0 : FIRST + 2 * live.catalogue.sonars + (i - 1) * (3 + 2 * live.catalogue.sonars);
// The robots of a frame: where each is, and where in the frame its ranges begin; its reasons follow them.
export function robotsOf(frame) {
  return Array.from({ length: live.scene.robots }, (_, i) => {
    const at = robotAt(i);
    return { x: frame[at], z: frame[at + 1], heading: frame[at + 2], at: i === 0 ? FIRST : at + 3 };
  });
}

function spacing(steps) {
  const fast = Number($('speed').value) / live.catalogue.step_s / FRAMES_PER_S, fine = TRAIL_M / live.scene.speed_m_per_s / live.catalogue.step_s;
  return live.playing || steps > FAR_STEPS ? Math.max(1, Math.floor(Math.min(fast, fine))) : 1;
}
// Frames are asked for a little before they are looked at; where the page stands still, the very one.
export async function fetchAhead(world) {
  if (world.asking) return;
  const at = Math.floor(live.now), aim = Math.max(live.now, live.wish);
  if (!live.playing && at < world.upTo && !world.frames[at]) return fetchFrames(world, Math.max(0, at - AROUND), 2 * AROUND, 1);
  const ahead = Math.max(400, Number($('speed').value) / live.catalogue.step_s);
  if (world.upTo > endStep() || world.upTo > aim + ahead) return;
  const every = world.upTo === 0 ? 1 : spacing(aim - world.upTo);
  return fetchFrames(world, world.upTo, world.upTo === 0 ? 200 : live.catalogue.most_frames, every);
}
async function fetchFrames(world, from, count, every) {
  world.asking = true;
  const asked = live.edition;
  try {
    const answer = await ask('/frames', { scene: sceneOf(world), from, count, every });
    if (asked !== live.edition) return;
    if (answer.fault) { fault(answer.fault); live.playing = false; return; }
    clear();
    answer.frames.forEach((frame, i) => {
      const step = from + i * every;
      world.frames[step] ??= frame;
      if (step >= world.upTo) { world.known.push(step); world.upTo = step + 1; }
    });
    live.dirty = true;
  } catch (e) {
    fault('NOT LIVE: ' + e.message + '. Is ./simbad studio still running?');
    live.playing = false;
    await new Promise(done => setTimeout(done, 1000));
  } finally {
    if (asked === live.edition) world.asking = false;
  }
}
// Every step from the start until now, for what is saved.
export async function allFrames(world) {
  const all = [], end = Math.min(Math.floor(live.now) + 1, world.upTo);
  while (all.length < end) {
    const answer = await ask('/frames', { scene: sceneOf(world), from: all.length, count: Math.min(live.catalogue.most_frames, end - all.length) });
    if (answer.fault) throw new Error(answer.fault);
    all.push(...answer.frames);
  }
  return all;
}
// What another view says is not the live world's to take away.
function clear() { if (!$('live').hidden) fault(''); }
const louds = new Map();
// Where the obstacle is how loud to a sensor that hears by levels; nothing until it is known.
export function loudness(sensor) {
  const key = [live.scene.obstacle, sensor, live.scene.sonar].join('\n');
  if (!louds.has(key)) {
    louds.set(key, null);
    ask('/loudness', { obstacle: live.scene.obstacle, sensor, sonar: live.scene.sonar }).then(answer => {
      louds.set(key, answer.fault ? null : answer.reach_m.map(row => row.map((m, i) => [m * Math.sin(2 * Math.PI * i / row.length), m * Math.cos(2 * Math.PI * i / row.length)])));
      live.dirty = true;
    }).catch(() => louds.delete(key));
  }
  return louds.get(key) || [];
}
// What is shown up to a step stays; the rest is another world from there.
export function change(keep) {
  live.edition++;
  live.wish = 0;
  live.robot = Math.min(live.robot, live.scene.robots - 1);
  worlds[0].sensor = live.scene.sensor;
  worlds[1].sensor = live.beside;
  for (const world of worlds) {
    world.frames.length = Math.min(world.frames.length, keep);
    world.known = world.known.filter(step => step < keep);
    world.upTo = Math.min(world.upTo, keep);
    world.asking = false;
    world.moved = null;
  }
  live.now = Math.max(0, keep === 0 ? live.now : Math.min(live.now, keep));
  clear();
  words();
  live.dirty = true;
}
// Four times the way once round, and then it ends: the bar's end never moves under the knob.
export function endStep() {
  const round = typeNow().round_m / live.scene.speed_m_per_s / live.catalogue.step_s;
  return Math.min(live.catalogue.most_steps, Math.max(2000, 500 * Math.ceil(4 * round / 500))) - 1;
}
// What was moved by hand stands there at once: until the program has answered, that step is what was seen, with the thing at its new place.
const reach = world => world.moved ? Math.max(world.upTo, world.moved.step + 1) : world.upTo;
export const most = () => Math.max(0, Math.min(...active().map(reach)) - 1);
// The step that is shown: the last one that is known by now.
export function stepOf(world) {
  let step = Math.min(Math.floor(live.now), reach(world) - 1);
  if (world.moved && step >= world.upTo) return world.moved.step;
  while (step > 0 && !world.frames[step]) step--;
  return step;
}
export const frameOf = world => world.moved && stepOf(world) >= world.upTo ? world.moved.frame : world.frames[stepOf(world)];
function movedIn(frame, thing, to, turn, number) {
  const copy = [...frame], at = thing === 'robot' ? robotAt(number) : FIRST - 3;
  copy[at] = to[0];
  copy[at + 1] = to[1];
  if (thing === 'obstacle') copy[at + 2] = turn;
  return copy;
}

export function setPlaying(on) { live.playing = on; if (on) live.wish = 0; $('play').textContent = on ? 'Pause' : 'Play'; live.dirty = true; }
// Where nobody has been yet it waits until the world is stepped so far.
export function go(step) { setPlaying(false); live.now = Math.max(0, Math.min(most(), step)); live.wish = step > live.now ? Math.min(step, endStep()) : 0; live.dirty = true; }
export function move(thing, at, turn, number = 0) {
  const seen = worlds.map(frameOf);
  const step = Math.floor(live.now), to = at.map(v => Math.round(Math.max(-20, Math.min(20, v)) * 1000) / 1000);
  if (thing === 'robot' && step === 0 && live.scene.robots === 1) {
    live.scene.start = to;
    live.scene.moves = live.scene.moves.filter(m => !m.robot);
  } else {
    // Of one thing moved again at one step the last place stands.
    live.scene.moves = live.scene.moves.filter(m => m.step < step || m.step === step && !(m[thing] && (m.number || 0) === number));
    live.scene.moves.push(thing === 'robot' ? { step, robot: to, ...(number ? { number } : {}) } : { step, obstacle: to, turn_deg: Math.round(turn * 1800 / Math.PI) / 10 });
  }
  change(step);
  worlds.forEach((world, i) => { if (seen[i]) world.moved = { step, frame: movedIn(seen[i], thing, to, turn, number) }; });
}
export const within = angle => Math.atan2(Math.sin(angle), Math.cos(angle));
