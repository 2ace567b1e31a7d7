// What is saved of the live world, and opened again.
import { $, csvText, fault, give, giveText } from './kit.js';
import { pair } from './pen.js';
import { draw } from './plan.js';
import { active, allFrames, AS_TOLD, change, FORMAT, live, robotIn, robotOf, robotsOf, sensorOf } from './state.js';
import { fields } from './words.js';

// One picture of all that is shown: two views stand beside each other.
export function svgNow() {
  const plans = active().map((world, i) => $('plan' + i));
  return pair(plans.map(canvas => [canvas.clientWidth, canvas.clientHeight]), draw, [live.scene.obstacle, ...active().map(world => world.sensor), $('clock').textContent].join(', '));
}
function pngNow() {
  const plans = active().map((world, i) => $('plan' + i)), whole = document.createElement('canvas');
  whole.width = plans.reduce((sum, one) => sum + one.width, 0);
  whole.height = plans[0].height;
  plans.reduce((x, one) => { whole.getContext('2d').drawImage(one, x, 0); return x + one.width; }, 0);
  whole.toBlob(blob => give('plan.png', blob));
}
export function saved() { return JSON.stringify({ ...live.scene, beside: live.beside, beside_robot: live.besideRobot }, null, 2) + '\n'; }
export function opened(text) {
  const read = JSON.parse(text);
  if (read.format !== FORMAT || !Array.isArray(read.moves)) throw new Error('it is not a scene of format ' + FORMAT);
  if (!live.catalogue.obstacles.some(o => o.name === read.obstacle)) throw new Error("there is no obstacle '" + read.obstacle + "'");
  for (const name of [read.sensor, read.beside || read.sensor])
    if (!sensorOf(name)) throw new Error("there is no sensor '" + name + "'");
  // Scenes from before there was a choice of them lack these.
  read.sonar ??= 'srf04';
  read.robot ??= '';
  read.robots ??= 1;
  if (!live.catalogue.transducers.some(one => one.name === read.sonar)) throw new Error("there is no sonar '" + read.sonar + "'");
  if (read.robot && !robotOf(read.robot)) throw new Error("there is no robot '" + read.robot + "': start with --robot");
  read.beside_robot ??= '';
  if (read.beside_robot && read.beside_robot !== AS_TOLD && !robotOf(read.beside_robot)) throw new Error("there is no robot '" + read.beside_robot + "': start with --robot");
  if (!Number.isInteger(read.robots) || read.robots < 1 || read.robots > live.catalogue.most_robots) throw new Error('robots is not in [1, ' + live.catalogue.most_robots + ']');
  live.beside = read.beside || '';
  live.besideRobot = read.beside_robot;
  delete read.beside;
  delete read.beside_robot;
  live.scene = read;
  live.now = 0;
  fields();
  change(0);
}
export async function csv() {
  const n = live.catalogue.sonars, heads = ['sensor', 'moves_as', 'robot', 'time_s', 'x_m', 'z_m', 'heading_deg', 'obstacle_x_m', 'obstacle_z_m', 'obstacle_turn_deg'], rows = [];
  for (let i = 0; i < n; i++) heads.push('range_' + Math.round(360 * i / n) + '_m');
  for (const [w, world] of active().entries())
    (await allFrames(world)).forEach((f, k) => robotsOf(f).forEach((one, i) => rows.push([world.sensor, robotIn(w), i + 1, (k * live.catalogue.step_s).toFixed(2), one.x, one.z, (one.heading * 180 / Math.PI).toFixed(2), f[3], f[4],
      (f[5] * 180 / Math.PI).toFixed(1), ...f.slice(one.at, one.at + n).map(r => r < 0 ? '' : (r / 1000).toFixed(3))])));
  return csvText(heads, rows);
}
$('save').addEventListener('click', () => giveText('scene.json', saved(), 'application/json'));
$('csv').addEventListener('click', async () => { try { giveText('trace.csv', await csv(), 'text/csv'); } catch (e) { fault(e.message); } });
$('picture').addEventListener('click', pngNow);
$('svg').addEventListener('click', () => giveText('plan.svg', svgNow(), 'image/svg+xml'));
$('open').addEventListener('change', async () => {
  const file = $('open').files[0];
  if (!file) return;
  try { opened(await file.text()); } catch (e) { fault(file.name + ': ' + e.message); }
  $('open').value = '';
});
