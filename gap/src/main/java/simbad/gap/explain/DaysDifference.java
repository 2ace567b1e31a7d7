package simbad.gap.explain;

import java.util.Map;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.SetupForms;

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

  /**
   * Returns a set-up with what of an explanation is no more than that.
   *
   * @param setup as known
   * @param explanation of a log of another day
   */
  static Hypothesis taken(Hypothesis setup, Hypothesis explanation) {
    Hypothesis taken = setup;
    for (int i = 0; i < explanation.forms().size(); i++) {
      Form form = explanation.forms().get(i);
      double[] values = explanation.valuesOf(i);
      Form asSetup = SetupForms.of(form);
      if (isSmall(form, values) && !setup.forms().contains(asSetup)) {
        taken = taken.and(asSetup, values);
      }
    }
    return taken;
  }

  private static boolean isSmall(Form form, double[] values) {
    if (form.effect() == Effect.OBSTACLE_OFFSET) {
      return Math.hypot(values[0], values[1]) < LEAST_OFFSET_M;
    }
    double least = LEAST.getOrDefault(form.effect(), 0.0);
    return Math.abs(values[0] - form.neutral()[0]) < least;
  }
}
