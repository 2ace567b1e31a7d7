// The live world: what is asked for, what is known of it, where in time the page is.
import { $, ask, fault } from './kit.js';
import { words } from './words.js';

export const FORMAT = 'simbad-studio/1', MOVE_M = 0.05, TURN_DEG = 5, HANDLE_PX = 34, RING_PX = 9, FIRST = 6;
export const live = {
  catalogue: null, colours: {}, beside: '', now: 0, playing: false, before: 0, near: '', chosen: -1, edition: 0, held: null, dirty: true, wish: 0,
  scene: { format: FORMAT, obstacle: '', sensor: '', sonar: 'srf04', robot: '', speed_m_per_s: 0.01, seed: 1, moves: [] },
};
export const worlds = [{ frames: [], asking: false, sensor: '' }, { frames: [], asking: false, sensor: '' }];
export const active = () => live.beside ? worlds : worlds.slice(0, 1);
export const typeNow = () => live.catalogue.obstacles.find(o => o.name === live.scene.obstacle);
export const sensorOf = name => live.catalogue.sensors.find(s => s.name === name);
// Half of the cone: a diagnosed sensor's own, else that of the sonar.
export const halfAngle = name => (sensorOf(name).half_angle_deg ?? live.catalogue.transducers.find(one => one.name === live.scene.sonar).half_angle_deg) * Math.PI / 180;
export const isOriginal = world => /^(original|ray)$/.test(world.sensor);
export const turned = ([x, z], turn) => [x * Math.cos(turn) + z * Math.sin(turn), z * Math.cos(turn) - x * Math.sin(turn)];

// Frames are asked for a little before they are looked at.
export async function fetchAhead(world) {
  const from = world.frames.length;
  const ahead = Math.max(400, 200 * Number($('speed').value) / 4);
  if (world.asking || from > endStep() || from > Math.max(live.now, live.wish) + ahead) return;
  world.asking = true;
  const asked = live.edition;
  try {
    const count = from === 0 ? 200 : live.catalogue.most_frames;
    const answer = await ask('/frames', { scene: { ...live.scene, sensor: world.sensor }, from, count });
    if (asked !== live.edition) return;
    if (answer.fault) { fault(answer.fault); live.playing = false; return; }
    fault('');
    world.frames.push(...answer.frames);
    live.dirty = true;
  } catch (e) {
    fault('NOT LIVE: ' + e.message + '. Is ./simbad studio still running?');
    live.playing = false;
    await new Promise(done => setTimeout(done, 1000));
  } finally {
    if (asked === live.edition) world.asking = false;
  }
}
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
  worlds[0].sensor = live.scene.sensor;
  worlds[1].sensor = live.beside;
  for (const world of worlds) { world.frames.length = Math.min(world.frames.length, keep); world.asking = false; }
  live.now = Math.max(0, keep === 0 ? live.now : Math.min(live.now, keep));
  fault('');
  words();
  live.dirty = true;
}
// Four times the way once round, and then it ends: the bar's end never moves under the knob.
export function endStep() {
  const round = typeNow().round_m / live.scene.speed_m_per_s / live.catalogue.step_s;
  return Math.min(live.catalogue.most_steps, Math.max(2000, 500 * Math.ceil(4 * round / 500))) - 1;
}
export const most = () => Math.max(0, Math.min(...active().map(w => w.frames.length)) - 1);
export const frameOf = world => world.frames[Math.min(Math.floor(live.now), world.frames.length - 1)];

export function setPlaying(on) { live.playing = on; if (on) live.wish = 0; $('play').textContent = on ? 'Pause' : 'Play'; live.dirty = true; }
// Where nobody has been yet it waits until the world is stepped so far.
export function go(step) { setPlaying(false); live.now = Math.max(0, Math.min(most(), step)); live.wish = step > live.now ? Math.min(step, endStep()) : 0; live.dirty = true; }
export function move(thing, at, turn) {
  const step = Math.floor(live.now), to = at.map(v => Math.round(Math.max(-20, Math.min(20, v)) * 1000) / 1000);
  if (thing === 'robot' && step === 0) {
    live.scene.start = to;
    live.scene.moves = live.scene.moves.filter(m => !m.robot);
  } else {
    // Of one thing moved again at one step the last place stands.
    live.scene.moves = live.scene.moves.filter(m => m.step < step || m.step === step && !m[thing]);
    live.scene.moves.push(thing === 'robot' ? { step, robot: to } : { step, obstacle: to, turn_deg: Math.round(turn * 1800 / Math.PI) / 10 });
  }
  change(step);
}
export const within = angle => Math.atan2(Math.sin(angle), Math.cos(angle));
