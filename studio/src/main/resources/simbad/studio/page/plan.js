// The plan view of the live world, seen from above.
import { $, themeColours } from './kit.js';
import { grid } from './sheet.js';
import { active, frameOf, halfAngle, HANDLE_PX, isOriginal, live, loudness, RING_PX, robotsOf, turned, typeNow, worlds } from './state.js';

const MOST_SEGMENTS = 6000;
export function readColours() {
  live.colours = themeColours(['paper', 'ink', 'soft', 'grid', 'shade', 'edge', 'body', 'trail', 'robot', 'heard', 'heardfill', 'loud', 'quiet', 'line']);
  live.dirty = true;
}
export function view(canvas, frame) {
  const w = canvas.clientWidth, h = canvas.clientHeight;
  const reach = Math.max(0.5, ...typeNow().edge.map(([x, z]) => Math.hypot(x, z)));
  const originals = active().some(isOriginal) ? typeNow().original_edge.map(p => Math.hypot(...p)) : [];
  const size = Math.max(...typeNow().parts.flat().map(p => Math.hypot(...p)));
  const radius = (live.near === 'robot' ? 0.5 : live.near === 'obstacle' ? Math.max(0.1, 1.6 * size) : 1.12 * Math.max(reach, ...originals)) / live.zoom;
  const scale = Math.min(w, h) / (2 * radius), robot = frame && robotsOf(frame)[live.robot];
  const about = !frame ? [0, 0] : live.near === 'robot' ? [robot.x, robot.z] : live.near === 'obstacle' ? [frame[3], frame[4]] : [0, 0];
  const centre = [about[0] + live.off[0], about[1] + live.off[1]];
  return { w, h, scale, centre, radius,
    x: m => w / 2 + (m - centre[0]) * scale, y: m => h / 2 + (m - centre[1]) * scale,
    back: (px, py) => [(px - w / 2) / scale + centre[0], (py - h / 2) / scale + centre[1]] };
}
export function path(g, v, points, ox, oz, turn) {
  points.map(p => turned(p, turn)).forEach(([x, z], i) => g[i ? 'lineTo' : 'moveTo'](v.x(x + ox), v.y(z + oz)));
  g.closePath();
}
function fit(canvas, w, h, ratio) {
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) {
    canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio);
  }
}
// What stands still - paper, grid, shadow, the trail until now - is drawn once, and the trail goes on where it ended.
const grounds = [0, 1].map(() => ({ canvas: document.createElement('canvas'), key: '', drawn: 0 }));
function ground(index, v, unit, ratio, ox, oz, turn) {
  const own = grounds[index], world = worlds[index], loud = loudness(world.sensor);
  const key = [v.w, v.h, ratio, v.scale, ...v.centre, ox, oz, turn, live.edition, world.sensor, loud.length, live.colours.paper].join();
  const g = own.canvas.getContext('2d');
  if (key !== own.key || trailEnd(world) < own.drawn) {
    fit(own.canvas, v.w, v.h, ratio);
    own.key = key;
    own.drawn = 0;
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    still(g, v, world, ox, oz, turn, unit);
  }
  own.drawn = trail(g, v, world, unit, own.drawn);
  return own.canvas;
}
function still(g, v, world, ox, oz, turn, unit) {
  g.fillStyle = live.colours.paper; g.fillRect(0, 0, v.w, v.h);
  grid(g, v, unit, live.colours);
  shadow(g, v, world, ox, oz, turn, unit);
}
export function draw(index, pen) {
  const canvas = $('plan' + index), world = worlds[index], frame = frameOf(world);
  const ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  fit(canvas, w, h, ratio);
  const g = pen || canvas.getContext('2d'), v = view(canvas, frame);
  const unit = Math.max(1, Math.min(w, h) / 500);
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  if (!frame) { g.fillStyle = live.colours.paper; g.fillRect(0, 0, w, h); return; }
  const grab = live.held && live.held.index === index ? live.held : null;
  const [ox, oz] = grab && grab.thing === 'obstacle' ? grab.at : [frame[3], frame[4]];
  const turn = grab && grab.thing === 'handle' ? grab.turn : frame[5];
  if (pen) {
    still(g, v, world, ox, oz, turn, unit);
    trail(g, v, world, unit, 0);
  } else if (w && h) {
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.drawImage(ground(index, v, unit, ratio, ox, oz, turn), 0, 0);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
  }
  const robots = robotsOf(frame).map((one, i) => grab && grab.thing === 'robot' && grab.number === i ? { ...one, x: grab.at[0], z: grab.at[1] } : one);
  robots.forEach((one, i) => cones(g, v, world, frame, one, unit, i === live.robot));
  g.fillStyle = live.colours.body; g.strokeStyle = live.colours.body; g.lineWidth = 2 * unit;
  for (const part of typeNow().parts) { g.beginPath(); path(g, v, part, ox, oz, turn); g.fill(); if (!isTiny(v)) g.stroke(); }
  marks(g, v, ox, oz, turn, unit);
  robots.forEach((one, i) => robot(g, v, one, unit, robots.length > 1 ? String(i + 1) : ''));
}
// Too small to see at this scale: a ring says where it is, and that it is not to scale.
export function isTiny(v) {
  const all = typeNow().parts.flat();
  return Math.max(...all.map(([x, z]) => Math.hypot(x, z))) * 2 * v.scale < 2 * RING_PX;
}
export function handleAt(v, ox, oz, turn) {
  const [x, z] = turned([0, 1], turn);
  return [v.x(ox) + HANDLE_PX * x, v.y(oz) + HANDLE_PX * z];
}
export function marks(g, v, ox, oz, turn, unit) {
  g.strokeStyle = live.colours.body; g.lineWidth = 1.5 * unit;
  if (isTiny(v)) { g.beginPath(); g.arc(v.x(ox), v.y(oz), RING_PX * unit, 0, 2 * Math.PI); g.stroke(); }
  const [hx, hy] = handleAt(v, ox, oz, turn);
  g.beginPath(); g.moveTo(v.x(ox), v.y(oz)); g.lineTo(hx, hy); g.stroke();
  g.beginPath(); g.rect(hx - 5, hy - 5, 10, 10); g.fillStyle = live.colours.paper; g.fill(); g.stroke();
}
export function shadow(g, v, world, ox, oz, turn, unit) {
  g.beginPath();
  path(g, v, typeNow().edge, ox, oz, turn);
  const loud = loudness(world.sensor);
  if (!loud.length) { g.fillStyle = live.colours.shade; g.fill(); }
  g.strokeStyle = live.colours.edge; g.lineWidth = 2 * unit; g.stroke();
  loud.forEach((points, i) => {
    g.beginPath(); path(g, v, points, ox, oz, turn);
    g.fillStyle = live.colours.loud; g.fill();
    if (i === 0) { g.strokeStyle = live.colours.heard; g.lineWidth = 1.5 * unit; g.stroke(); }
  });
  g.strokeStyle = live.colours.edge; g.lineWidth = 2 * unit;
  if (isOriginal(world)) {
    g.setLineDash([8 * unit, 6 * unit]);
    g.beginPath(); path(g, v, typeNow().original_edge, ox, oz, turn); g.stroke();
    g.setLineDash([]);
  }
}
// How many of the known steps are past.
function trailEnd(world) {
  const known = world.known, now = Math.floor(live.now);
  let low = 0, high = known.length;
  while (low < high) { const middle = (low + high) >> 1; if (known[middle] <= now) low = middle + 1; else high = middle; }
  return low;
}
// Draws the trails from one of the known steps on, and says how far.
export function trail(g, v, world, unit, from) {
  const end = trailEnd(world);
  if (end === from || !world.frames[0]) return from;
  const every = Math.max(1, Math.floor((end - from) * live.scene.robots / MOST_SEGMENTS));
  const known = [];
  for (let i = Math.max(0, from - 1); i < end; i += every) known.push(world.known[i]);
  if (known.at(-1) !== world.known[end - 1]) known.push(world.known[end - 1]);
  const places = known.map(step => robotsOf(world.frames[step]));
  g.strokeStyle = live.colours.trail; g.fillStyle = live.colours.trail; g.lineWidth = 2.5 * unit; g.lineJoin = 'round';
  for (let i = 0; i < live.scene.robots; i++) {
    g.beginPath();
    places.forEach((robots, k) => {
      const { x, z } = robots[i], before = k > 0 && places[k - 1][i];
      // A robot that was carried left no trail.
      const carried = before && Math.hypot(x - before.x, z - before.z) > 0.02 + 2 * (known[k] - known[k - 1]) * live.scene.speed_m_per_s * live.catalogue.step_s;
      g[!before || carried ? 'moveTo' : 'lineTo'](v.x(x), v.y(z));
    });
    g.stroke();
    if (from === 0) { g.beginPath(); g.arc(v.x(places[0][i].x), v.y(places[0][i].z), 4 * unit, 0, 2 * Math.PI); g.fill(); }
  }
  return end;
}
export function cones(g, v, world, frame, { x, z, heading, at }, unit, isChosen) {
  const n = live.catalogue.sonars, half = halfAngle(world.sensor);
  const quiet = Math.min(v.w, v.h) * (live.scene.robots > 1 ? 0.04 : 0.09);
  for (let i = 0; i < n; i++) {
    const range = frame[at + i], to = -(heading + 2 * Math.PI * i / n), chosen = isChosen && i === live.chosen;
    const long = half === 0 && range < 0 ? 2.5 * v.scale : range >= 0 ? range / 1000 * v.scale : chosen ? Math.hypot(v.w, v.h) : quiet;
    g.beginPath(); g.moveTo(v.x(x), v.y(z)); g.arc(v.x(x), v.y(z), long, to - half, to + half); g.closePath();
    g.setLineDash(range >= 0 ? [] : [3 * unit, 4 * unit]);
    if (range >= 0) { g.fillStyle = live.colours.heardfill; g.fill(); }
    g.strokeStyle = range >= 0 ? live.colours.heard : live.colours.quiet;
    g.lineWidth = (chosen ? 3 : 1) * unit;
    g.globalAlpha = range >= 0 || chosen ? 1 : 0.55;
    g.stroke();
    if (range >= 0) { g.beginPath(); g.setLineDash([]); g.lineWidth = 3 * unit; g.arc(v.x(x), v.y(z), long, to - half, to + half); g.stroke(); }
    g.globalAlpha = 1;
  }
  g.setLineDash([]);
}
export function robot(g, v, { x, z, heading }, unit, name) {
  const r = Math.max(0.02 * v.scale, 7 * unit);
  g.beginPath(); g.arc(v.x(x), v.y(z), r, 0, 2 * Math.PI);
  g.fillStyle = live.colours.paper; g.fill(); g.strokeStyle = live.colours.robot; g.lineWidth = 2.5 * unit; g.stroke();
  g.beginPath(); g.moveTo(v.x(x), v.y(z)); g.lineTo(v.x(x) + 1.9 * r * Math.cos(heading), v.y(z) - 1.9 * r * Math.sin(heading)); g.stroke();
  if (!name) return;
  g.fillStyle = live.colours.ink; g.font = Math.max(13, 13 * unit) + 'px system-ui, sans-serif'; g.textAlign = 'left'; g.textBaseline = 'bottom';
  g.fillText(name, v.x(x) + r, v.y(z) - r);
}
