package simbad.gap.explain;

import java.util.Map;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Effect;

/**
 * What differs from one day to the next though nothing was changed: the air's temperature by half a
 * degree and its absorption with it, a supply's voltage, what was put up again by tape and
 * protractor. A set-up that is known to a decibel would show each of these as an effect.
 */
final class DaysDifference {
  /** Departures from neutral, in the units of the forms' first values; twice a day's deviation. */
  private static final Map<Effect, Double> LEAST =
      Map.of(
          // 0.15 dB.
          Effect.GAIN, 0.3,
          // The same at a metre and a half, there and back.
          Effect.ABSORPTION, 0.1,
          // Half a kelvin is 0.3 m/s.
          Effect.SOUND_SPEED, 0.6,
          // A quarter of a degree on a protractor.
          Effect.OBSTACLE_TURN, 0.5,
          Effect.BEAM_MISALIGNMENT, 0.5);

  /** Twice what a tape is read off to, in either direction. */
  private static final double LEAST_OFFSET_M = 0.004;

  private DaysDifference() {}

  /** Tells whether an explanation names what is no more than that. */
  static boolean isIn(Hypothesis explanation) {
    for (int i = 0; i < explanation.forms().size(); i++) {
      double[] values = explanation.valuesOf(i);
      double[] neutral = explanation.forms().get(i).neutral();
      Effect effect = explanation.forms().get(i).effect();
      Double least = LEAST.get(effect);
      if (least != null && Math.abs(values[0] - neutral[0]) < least) {
        return true;
      }
      if (effect == Effect.OBSTACLE_OFFSET && Math.hypot(values[0], values[1]) < LEAST_OFFSET_M) {
        return true;
      }
    }
    return false;
  }
}
