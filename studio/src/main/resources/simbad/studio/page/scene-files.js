// What is saved of the live world, and opened again.
import { $, escaped, fault, give } from './kit.js';
import { SvgPen } from './pen.js';
import { draw } from './plan.js';
import { change, FIRST, FORMAT, live, sensorOf, worlds } from './state.js';
import { fields } from './words.js';

export function svgOf(index) {
  const canvas = $('plan' + index), pen = new SvgPen(canvas.clientWidth, canvas.clientHeight);
  draw(index, pen);
  return pen.text(live.scene.obstacle + ', ' + worlds[index].sensor + ', ' + $('clock').textContent);
}
export function saved() { return JSON.stringify({ ...live.scene, beside: live.beside }, null, 2) + '\n'; }
export function opened(text) {
  const read = JSON.parse(text);
  if (read.format !== FORMAT || !Array.isArray(read.moves)) throw new Error('it is not a scene of format ' + FORMAT);
  if (!live.catalogue.obstacles.some(o => o.name === read.obstacle)) throw new Error("there is no obstacle '" + read.obstacle + "'");
  for (const name of [read.sensor, read.beside || read.sensor])
    if (!sensorOf(name)) throw new Error("there is no sensor '" + name + "'");
  // Scenes from before there was a choice of them lack these.
  read.sonar ??= 'srf04';
  read.robot ??= '';
  if (!live.catalogue.transducers.some(one => one.name === read.sonar)) throw new Error("there is no sonar '" + read.sonar + "'");
  if (read.robot && !live.catalogue.robots.includes(read.robot)) throw new Error("there is no robot '" + read.robot + "': start with --robot");
  live.beside = read.beside || '';
  delete read.beside;
  live.scene = read;
  live.now = 0;
  fields();
  change(0);
}
export function csv() {
  const n = live.catalogue.sonars, heads = ['time_s', 'x_m', 'z_m', 'heading_deg', 'obstacle_x_m', 'obstacle_z_m', 'obstacle_turn_deg'];
  for (let i = 0; i < n; i++) heads.push('range_' + Math.round(360 * i / n) + '_m');
  const lines = worlds[0].frames.slice(0, Math.floor(live.now) + 1).map((f, k) =>
    [(k * live.catalogue.step_s).toFixed(2), f[0], f[1], (f[2] * 180 / Math.PI).toFixed(2), f[3], f[4],
      (f[5] * 180 / Math.PI).toFixed(1), ...f.slice(FIRST, FIRST + n).map(r => r < 0 ? '' : (r / 1000).toFixed(3))].join(','));
  return heads.join(',') + '\n' + lines.join('\n') + '\n';
}
$('save').addEventListener('click', () => give('scene.json', new Blob([saved()], { type: 'application/json' })));
$('csv').addEventListener('click', () => give('trace.csv', new Blob([csv()], { type: 'text/csv' })));
$('picture').addEventListener('click', () => $('plan0').toBlob(blob => give('plan.png', blob)));
$('svg').addEventListener('click', () => give('plan.svg', new Blob([svgOf(0)], { type: 'image/svg+xml' })));
$('open').addEventListener('change', async () => {
  const file = $('open').files[0];
  if (!file) return;
  try { opened(await file.text()); } catch (e) { fault(file.name + ': ' + e.message); }
  $('open').value = '';
});
