// A diagnosis of a joint log: what both halves say of one cause, then the readings, then the motion.
import { el, number, table } from './kit.js';
import { motionParts } from './motion.js';
import { showSensing } from './sensing.js';

// Half a unit of the last digit goes up, as in the program's own sentence.
const four = value => number(value + 1e-9 * Math.abs(value), 4);
const estimate = one => !one || one.value === undefined || one.value === null || (one.ci95 || [null])[0] === null ? 'open' : four(one.value) + ' (' + four(one.ci95[0]) + ' to ' + four(one.ci95[1]) + ')';
export function showJoint(page, answer, other) {
  const shared = answer.diagnosis.shared || [], motion = answer.diagnosis.motion || {};
  const closeSensing = showSensing(page, answer, other);
  if (shared.length) page.append(el('section', {}, el('h3', {}, 'One cause, one value'), table('One cause, one value', ['cause', 'heard as', 'parameter', '#tracker', '#sonar', '#both together'],
    shared.map(one => [one.name, one.heard_as, one.parameter, estimate(one.tracker), estimate(one.sonar), one.one_cause ? estimate(one.together) : 'two causes']))));
  page.append(el('h2', {}, 'The motion: ' + (motion.verdict || 'not diagnosed')), motion.reason ? el('p', {}, motion.reason + '.') : '');
  const closeMotion = motionParts(page, [answer, other].filter(Boolean), one => one.diagnosis.motion);
  return () => { closeSensing(); closeMotion(); };
}
