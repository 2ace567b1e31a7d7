package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Commands that act late, or clocks that differ. */
record Delay(double lateS) implements MotionChange {
  static final MotionForm LATENCY =
      new MotionForm(
          "actuation-latency",
          "actuation-latency",
          List.of(new MotionParameter("latency_s", 0, 2, 0, 0.01)),
          List.of(new double[] {0.1}, new double[] {0.4}),
          p -> new Delay(p[0]),
          "let commands act %s s late",
          false);
  static final MotionForm CLOCKS =
      new MotionForm(
          "time-offset",
          "time-offset",
          List.of(new MotionParameter("offset_s", -5, 5, 0, 0.01)),
          List.of(new double[] {0.1}, new double[] {-0.1}, new double[] {0.8}, new double[] {-0.8}),
          p -> new Delay(p[0]),
          "take %s s from the track's times",
          true);

  @Override
  public double delayS(double delayS) {
    return delayS + lateS;
  }
}
