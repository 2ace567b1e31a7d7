// The plan view of the live world, seen from above.
import { $, themeColours } from './kit.js';
import { grid } from './sheet.js';
import { active, FIRST, frameOf, halfAngle, HANDLE_PX, isOriginal, live, loudness, RING_PX, turned, typeNow, worlds } from './state.js';

export function readColours() {
  live.colours = themeColours(['paper', 'ink', 'soft', 'grid', 'shade', 'edge', 'body', 'trail', 'robot', 'heard', 'heardfill', 'loud', 'quiet', 'line']);
  live.dirty = true;
}
export function view(canvas, frame) {
  const w = canvas.clientWidth, h = canvas.clientHeight;
  const reach = Math.max(0.5, ...typeNow().edge.map(([x, z]) => Math.hypot(x, z)));
  const originals = active().some(isOriginal) ? typeNow().original_edge.map(p => Math.hypot(...p)) : [];
  const size = Math.max(...typeNow().parts.flat().map(p => Math.hypot(...p)));
  const radius = live.near === 'robot' ? 0.5 : live.near === 'obstacle' ? Math.max(0.1, 1.6 * size) : 1.12 * Math.max(reach, ...originals);
  const scale = Math.min(w, h) / (2 * radius);
  const centre = !frame ? [0, 0] : live.near === 'robot' ? [frame[0], frame[1]] : live.near === 'obstacle' ? [frame[3], frame[4]] : [0, 0];
  return { w, h, scale, centre, radius,
    x: m => w / 2 + (m - centre[0]) * scale, y: m => h / 2 + (m - centre[1]) * scale,
    back: (px, py) => [(px - w / 2) / scale + centre[0], (py - h / 2) / scale + centre[1]] };
}
export function path(g, v, points, ox, oz, turn) {
  points.map(p => turned(p, turn)).forEach(([x, z], i) => g[i ? 'lineTo' : 'moveTo'](v.x(x + ox), v.y(z + oz)));
  g.closePath();
}
export function draw(index, pen) {
  const canvas = $('plan' + index), world = worlds[index], frame = frameOf(world);
  const ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) {
    canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio);
  }
  const g = pen || canvas.getContext('2d'), v = view(canvas, frame);
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.fillStyle = live.colours.paper; g.fillRect(0, 0, w, h);
  const unit = Math.max(1, Math.min(w, h) / 500);
  grid(g, v, unit, live.colours);
  if (!frame) return;
  const grab = live.held && live.held.index === index ? live.held : null;
  const [ox, oz] = grab && grab.thing === 'obstacle' ? grab.at : [frame[3], frame[4]];
  const [rx, rz] = grab && grab.thing === 'robot' ? grab.at : [frame[0], frame[1]];
  const turn = grab && grab.thing === 'handle' ? grab.turn : frame[5];
  shadow(g, v, world, ox, oz, turn, unit);
  trail(g, v, world, unit);
  cones(g, v, world, frame, rx, rz, unit);
  g.fillStyle = live.colours.body; g.strokeStyle = live.colours.body; g.lineWidth = 2 * unit;
  for (const part of typeNow().parts) { g.beginPath(); path(g, v, part, ox, oz, turn); g.fill(); if (!isTiny(v)) g.stroke(); }
  marks(g, v, ox, oz, turn, unit);
  robot(g, v, rx, rz, frame[2], unit);
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
export function trail(g, v, world, unit) {
  const end = Math.min(Math.floor(live.now), world.frames.length - 1), every = Math.max(1, Math.floor(end / 6000));
  g.strokeStyle = live.colours.trail; g.lineWidth = 2.5 * unit; g.lineJoin = 'round';
  g.beginPath();
  let px = null, pz = null;
  for (let i = 0; i <= end; i += every) {
    const [x, z] = world.frames[i];
    // A robot that was carried left no trail.
    const carried = px !== null && Math.hypot(x - px, z - pz) > 0.02 + 2 * every * live.scene.speed_m_per_s * live.catalogue.step_s;
    g[px === null || carried ? 'moveTo' : 'lineTo'](v.x(x), v.y(z));
    px = x; pz = z;
  }
  g.stroke();
  const [sx, sz] = world.frames[0];
  g.beginPath(); g.arc(v.x(sx), v.y(sz), 4 * unit, 0, 2 * Math.PI); g.fillStyle = live.colours.trail; g.fill();
}
export function cones(g, v, world, frame, x, z, unit) {
  const n = live.catalogue.sonars, half = halfAngle(world.sensor);
  const quiet = Math.min(v.w, v.h) * 0.09;
  for (let i = 0; i < n; i++) {
    const range = frame[FIRST + i], at = -(frame[2] + 2 * Math.PI * i / n);
    const long = half === 0 && range < 0 ? 2.5 * v.scale : range >= 0 ? range / 1000 * v.scale : i === live.chosen ? Math.hypot(v.w, v.h) : quiet;
    g.beginPath(); g.moveTo(v.x(x), v.y(z)); g.arc(v.x(x), v.y(z), long, at - half, at + half); g.closePath();
    g.setLineDash(range >= 0 ? [] : [3 * unit, 4 * unit]);
    if (range >= 0) { g.fillStyle = live.colours.heardfill; g.fill(); }
    g.strokeStyle = range >= 0 ? live.colours.heard : live.colours.quiet;
    g.lineWidth = (i === live.chosen ? 3 : 1) * unit;
    g.globalAlpha = range >= 0 || i === live.chosen ? 1 : 0.55;
    g.stroke();
    if (range >= 0) { g.beginPath(); g.setLineDash([]); g.lineWidth = 3 * unit; g.arc(v.x(x), v.y(z), long, at - half, at + half); g.stroke(); }
    g.globalAlpha = 1;
  }
  g.setLineDash([]);
}
export function robot(g, v, x, z, heading, unit) {
  const r = Math.max(0.02 * v.scale, 7 * unit);
  g.beginPath(); g.arc(v.x(x), v.y(z), r, 0, 2 * Math.PI);
  g.fillStyle = live.colours.paper; g.fill(); g.strokeStyle = live.colours.robot; g.lineWidth = 2.5 * unit; g.stroke();
  g.beginPath(); g.moveTo(v.x(x), v.y(z)); g.lineTo(v.x(x) + 1.9 * r * Math.cos(heading), v.y(z) - 1.9 * r * Math.sin(heading)); g.stroke();
}
