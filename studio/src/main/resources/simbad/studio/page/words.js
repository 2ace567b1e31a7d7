// What the live page says in words.
import { $ } from './kit.js';
import { FIRST, frameOf, live, sensorOf, typeNow, worlds } from './state.js';

export function quote(text) { return /^[A-Za-z0-9_.:,/-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'"; }
export function option(name) { return sensorOf(name).diagnosed ? 'diagnosed:DIR' : name; }
export function words() {
  const sensors = live.beside ? [live.scene.sensor, live.beside] : [live.scene.sensor];
  const start = live.scene.start ? ' --start=' + live.scene.start.map(v => v.toFixed(3)).join(',') : '';
  $('line').textContent = './simbad run ' + quote(live.scene.obstacle) + sensors.map(s => ' --sensor ' + quote(option(s))).join('')
    + (live.scene.sonar === 'srf04' ? '' : ' --sensor-file data/sensors/' + live.scene.sonar + '.json') + (live.scene.robot ? ' --robot diagnosed:DIR' : '')
    + start + ' --speed ' + live.scene.speed_m_per_s + ' --seed ' + live.scene.seed + ' --out run';
  const notes = [];
  if (sensors.some(s => sensorOf(s).diagnosed)) notes.push('DIR is the folder of the diagnosis.');
  if (live.scene.robot) notes.push('With --robot each sensor is driven twice: on the exact robot, and on ' + live.scene.robot + ' (DIR is the folder of its diagnosis; for a robot.json write the name of the file).');
  if (live.scene.moves.length) notes.push('The command does not know the moves by hand (' + live.scene.moves.length + '); the saved scene does.');
  $('linenote').textContent = notes.join(' ') || 'This command has the same start, controller and seed, so it gives the same trace.';
  $('meaning').textContent = live.scene.sensor + ': ' + sensorOf(live.scene.sensor).meaning + (live.beside ? '. ' + live.beside + ': ' + sensorOf(live.beside).meaning : '')
    + '. Table of ' + live.scene.obstacle + ': ' + typeNow().provenance + '.';
  $('second').hidden = !live.beside;
  $('views').classList.toggle('two', Boolean(live.beside));
  $('whyhead').textContent = 'Why no echo' + (live.beside ? ' (' + live.scene.sensor + ')' : '');
}
export function why(code) {
  if (code >= 100) return code === 1090 ? 'over 99 dB too weak' : ((code - 100) / 10).toFixed(1) + ' dB too weak';
  return ['', 'not in the cone', 'outside the shadow', 'missed by chance', 'out of range', 'its ray passes by', 'cone and shadow do not meet'][code];
}
export function rows() {
  const frame = frameOf(worlds[0]), n = live.catalogue.sonars;
  if (!frame) return;
  let heard = 0;
  for (let i = 0; i < n; i++) {
    const range = frame[FIRST + i], row = $('rows').children[i];
    row.className = (range >= 0 ? 'heard' : '') + (i === live.chosen ? ' chosen' : '');
    row.children[1].textContent = range >= 0 ? (range / 1000).toFixed(2) + ' m' : 'no echo';
    row.children[2].textContent = range >= 0 ? 'heard' : why(frame[FIRST + n + i]);
    heard += range >= 0;
  }
  if (!live.playing) $('said').textContent = heard + ' of ' + n + ' sonars hear the obstacle.';
}
export function fields() {
  $('obstacle').value = live.scene.obstacle; $('sensor0').value = live.scene.sensor; $('sensor1').value = live.beside;
  $('sonar').value = live.scene.sonar; $('robot').value = live.scene.robot;
  $('drive').value = live.scene.speed_m_per_s; $('seed').value = live.scene.seed;
}
