// What the live page says in words.
import { $ } from './kit.js';
import { active, frameOf, live, robotIn, robotOf, robotsOf, sensorOf, typeNow } from './state.js';

export function quote(text) { return /^[A-Za-z0-9_.:,/-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'"; }
export function words() {
  const scene = live.scene, sensors = [...new Set([scene.sensor, live.beside].filter(Boolean))];
  const moving = [...new Set([robotIn(0), live.beside ? robotIn(1) : ''])].filter(Boolean);
  const start = scene.start ? ' --start=' + scene.start.map(v => v.toFixed(3)).join(',') : '';
  $('line').textContent = './simbad run ' + quote(scene.obstacle) + sensors.map(s => ' --sensor ' + quote(sensorOf(s).option)).join('')
    + (scene.sonar === 'srf04' ? '' : ' --sensor-file data/sensors/' + scene.sonar + '.json') + moving.map(name => ' --robot ' + quote(robotOf(name).option)).join('')
    + start + ' --speed ' + scene.speed_m_per_s + ' --seed ' + scene.seed + ' --out run';
  const notes = [];
  if (moving.length === 1) notes.push('With --robot each sensor is driven twice: on the exact robot, and on ' + moving[0] + '.');
  if (moving.length > 1) notes.push('The command takes one robot: call it once for each.');
  const lacks = [scene.robots > 1 ? 'the other robots' : '', scene.moves.length ? 'the moves by hand (' + scene.moves.length + ')' : ''].filter(Boolean).join(' and ');
  if (lacks) notes.push('The command does not know ' + lacks + '. Save the scene, and ./simbad studio' + [...sensors.map(s => [sensorOf(s), ' --sensor ']), ...moving.map(name => [robotOf(name), ' --robot '])].filter(([one]) => one && one.option !== one.name).map(([one, option]) => option + quote(one.option)).join('') + ' --scene scene.json shows all of it.');
  $('linenote').textContent = notes.join(' ') || 'This command has the same start, controller and seed, so it gives the same trace.';
  $('meaning').textContent = sensors.map(name => name + ': ' + sensorOf(name).meaning).join('. ')
    + '. Table of ' + scene.obstacle + ': ' + typeNow().provenance + '.' + (scene.robots > 1 ? ' Robots do not hear each other, except with ray; where two touch, they stop.' : '');
  $('second').hidden = !live.beside;
  $('robot1row').hidden = !live.beside || !live.catalogue.robots.length;
  for (const id of ['views', 'live']) $(id).classList.toggle('two', Boolean(live.beside));
  heads();
  $('whichrow').hidden = scene.robots === 1;
  $('which').replaceChildren(...Array.from({ length: scene.robots }, (_, i) => new Option('Robot ' + (i + 1), String(i))));
  $('which').value = String(live.robot);
}
// With two sensors the table has a column for each.
function heads() {
  const both = active().length > 1, cell = (text, right) => { const th = document.createElement('th'); th.scope = 'col'; th.textContent = text; if (right) th.className = 'r'; return th; };
  $('heads').replaceChildren(cell('Looks', true), ...(both ? [live.scene.sensor, live.beside].map((name, i) => cell(name + (robotIn(i) ? ', ' + robotIn(i) : ''))) : [cell('Reads', true), cell('Why no echo')]));
  $('rows').parentElement.classList.toggle('both', both);
}
export function why(code) {
  if (code >= 100) return code === 1090 ? '> 99 dB too weak' : ((code - 100) / 10).toFixed(1) + ' dB too weak';
  return ['', 'not in the cone', 'outside the shadow', 'missed by chance', 'out of range', 'its ray passes by', 'cone and shadow do not meet'][code];
}
// Only what is other than before: to lay out a page takes longer than to draw a plan.
function put(element, text) { if (element.textContent !== text) element.textContent = text; }
function show(cell, text, isHeard) { put(cell, text); cell.classList.toggle('heard', isHeard); }
export function rows() {
  const n = live.catalogue.sonars, both = active().length > 1;
  let heard = 0;
  active().forEach((world, w) => {
    const frame = frameOf(world);
    if (!frame) return;
    const at = robotsOf(frame)[live.robot].at;
    for (let i = 0; i < n; i++) {
      const range = frame[at + i], cells = $('rows').rows[i].cells, reads = range >= 0 ? (range / 1000).toFixed(2) + ' m' : 'no echo', reason = why(frame[at + n + i]);
      if (both) show(cells[1 + w], range >= 0 ? reads : reason, range >= 0);
      else { show(cells[1], reads, range >= 0); show(cells[2], range >= 0 ? 'heard' : reason, range >= 0); }
      heard += w === 0 && range >= 0;
    }
  });
  [...$('rows').rows].forEach((row, i) => row.classList.toggle('chosen', i === live.chosen));
  if (!live.playing) put($('said'), heard + ' of ' + n + ' sonars hear the obstacle' + (live.beside ? ' with ' + live.scene.sensor : '') + '.');
}
export function fields() {
  $('obstacle').value = live.scene.obstacle; $('sensor0').value = live.scene.sensor; $('sensor1').value = live.beside;
  $('sonar').value = live.scene.sonar; $('robot').value = live.scene.robot; $('robot1').value = live.besideRobot; $('robots').value = String(live.scene.robots);
  $('drive').value = live.scene.speed_m_per_s; $('seed').value = live.scene.seed;
}
