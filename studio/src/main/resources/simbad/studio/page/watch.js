// A capture, as it goes on: for a person two metres off. The program tells what is new (server-sent events).
import { csvText, giveText, savedSvg } from './kit.js';

const svg = document.getElementById("plot");
const RADIUS = 300;
function put(id, text, style) {
  const element = document.getElementById(id);
  element.textContent = text;
  if (style !== undefined) element.className = style;
}
function add(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text) element.textContent = text;
  svg.appendChild(element);
}
// Bearing 0 looks along +z, down the page; 90 along +x, to the right.
function at(deg, length) {
  const rad = deg * Math.PI / 180;
  return [length * Math.sin(rad), length * Math.cos(rad)];
}
function axes(most) {
  const step = most > 2 ? 1 : 0.5;
  for (let m = step; m <= most + 1e-9; m += step) add("circle", {cx: 0, cy: 0, r: m / most * RADIUS, class: "ring"});
  for (let deg = 0; deg < 360; deg += 30) {
    const [x2, y2] = at(deg, RADIUS), [x, y] = at(deg, RADIUS + 26);
    add("line", {x1: 0, y1: 0, x2, y2, class: "spoke"});
    add("text", {x, y, class: "degrees"}, deg + "\u00b0");
  }
}
/** Over all else, so that the numbers can be read. */
function scale(most) {
  const step = most > 2 ? 1 : 0.5;
  for (let m = step; m <= most + 1e-9; m += step) {
    const [x, y] = at(165, m / most * RADIUS);
    add("text", {x: x - 3, y: y + 15, "text-anchor": "end"}, m + " m");
  }
}
function draw(state) {
  svg.replaceChildren();
  const points = state.points || [], levels = state.levels || [];
  const most = Math.ceil(Math.max(1, ...points.map(p => p[3]), ...levels.map(l => l[0])));
  const length = m => m / most * RADIUS;
  axes(most);
  const turn = 360 / state.bearings;
  points.forEach((p, i) => {
    // Between bearings that were not swept nothing is known: no edge there.
    const q = points[(i + 1) % points.length];
    if (points.length > 1 && Math.abs((q[0] - p[0] + 360) % 360 - turn) < 1e-6) {
      const from = at(p[0], length(p[1])), to = at(q[0], length(q[1]));
      add("polygon", {points: [[0, 0], from, to].join(" "), class: "table"});
      add("polyline", {points: [from, to].join(" "), class: "edge"});
    }
  });
  for (const p of points) {
    const [x1, y1] = at(p[0], length(p[2])), [x2, y2] = at(p[0], length(p[3])), [cx, cy] = at(p[0], length(p[1]));
    add("line", {x1, y1, x2, y2, class: "interval"});
    add("circle", {cx, cy, r: 4, class: "dot"});
  }
  if (state.done < state.bearings) {
    const [x2, y2] = at(state.bearing_deg, RADIUS);
    add("line", {x1: 0, y1: 0, x2, y2, class: "now"});
    for (const [m, pings, , lost] of levels) {
      const [cx, cy] = at(state.bearing_deg, length(m));
      add("circle", {cx, cy, r: 7, class: lost ? "lost" : pings < state.pings_each ? "open" : "heard"});
    }
  }
  scale(most);
}
let begun, before = {readings: -1}, since = Date.now(), failures = 0, source = null, clock = null;
function left(state) {
  if (!begun || state.done < begun.done) begun = {done: state.done, at: Date.now()};
  if (state.done === begun.done) return "";
  const minutes = (Date.now() - begun.at) / (state.done - begun.done) * (state.bearings - state.done) / 60000;
  return ", about " + Math.ceil(minutes) + " min left";
}
function tell(state) {
  const number = /^[0-9.]+$/.test(state.reading_cm);
  put("reading", number ? Number(state.reading_cm).toFixed(1) : state.reading_cm, number ? "large" : "large alarm");
  put("captured", state.obstacle);
  put("bearing", state.bearing_deg + "\u00b0");
  const last = (state.levels || []).slice(-1)[0];
  put("level", last ? (last[3] ? "LOST at " : "at ") + (last[0] * 100).toFixed(1) + " cm to the axis: "
    + last[2] + " of " + last[1] + " heard" : "no reading at this bearing yet", last && last[3] ? "line alarm" : "line");
  const done = state.done === state.bearings;
  put("progresstext", state.done + " of " + state.bearings + " bearings, " + state.pings + " pings" + (done ? "" : left(state)));
  document.getElementById("progress").value = state.done / state.bearings;
}
function live(state) {
  const silentS = Math.round((Date.now() - since) / 1000);
  if (state.done === state.bearings) put("state", "all bearings are done", "line fine");
  else if (silentS >= 3) put("state", "no reading for " + silentS + " s (paused, or the board is silent)", "line alarm");
  else put("state", "live", "line fine");
}
// How long nothing was read is told by the clock, not by the program.
const SILENT_EVERY_MS = 500, LOST_AFTER = 3;
function hear(state) {
  failures = 0;
  if (state.fault) return gone(state.fault);
  if (!state.bearings) return put("state", "the capture begins", "line");
  // In a folder readings are counted in the journal alone.
  if (state.readings !== before.readings || state.pings !== before.pings) since = Date.now();
  before = state;
  tell(state);
  draw(state);
  return live(state);
}
function gone(why) {
  const whole = before.bearings && before.done === before.bearings;
  put("state", whole ? "done: the capture has ended" : "NOT LIVE: " + why, whole ? "line fine" : "line alarm");
  if (!whole) put("reading", "-", "large alarm");
}
// Without a path it is the capture that this very program makes.
export function watch(path) {
  leave();
  begun = undefined;
  before = {readings: -1};
  since = Date.now();
  failures = 0;
  document.getElementById("home").href = "#" + new URLSearchParams({open: path || "."});
  source = new EventSource("watch" + location.search + (path ? "&path=" + encodeURIComponent(path) : ""));
  source.onmessage = event => hear(JSON.parse(event.data));
  // The browser asks again by itself; one answer may be lost on a busy machine or network.
  source.onerror = () => { if (++failures >= LOST_AFTER || source.readyState === EventSource.CLOSED) gone("the capture has ended or cannot be reached"); };
  clock = setInterval(() => { if (before.bearings && failures === 0) live(before); }, SILENT_EVERY_MS);
}
export function leave() {
  if (source) source.close();
  clearInterval(clock);
  source = null;
}
const HEADS = ["bearing_deg", "threshold_m", "low_m", "high_m"];
document.getElementById("watchsvg").addEventListener("click", () => giveText("capture.svg", savedSvg(svg), "image/svg+xml"));
document.getElementById("watchcsv").addEventListener("click", () => giveText("capture.csv", csvText(HEADS, before.points || []), "text/csv"));
