package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Commands that act late, or clocks that differ. */
record Delay(double lateS) implements MotionChange {
  static final MotionForm LATENCY =
      new MotionForm(
          "actuation-latency",
          "actuation-latency",
          List.of(MotionParameter.smooth("latency_s", 0, 2, 0, 0.02).tried(0.05, 0.15, 0.4)),
          p -> new Delay(p[0]),
          "delay commands by %s s",
          false);
  static final MotionForm CLOCKS =
      new MotionForm(
          "time-offset",
          "time-offset",
          List.of(
              MotionParameter.smooth("offset_s", -5, 5, 0, 0.02)
                  .tried(0.05, -0.05, 0.2, -0.2, 0.5, -0.5, 1, -1, 2, -2, 4, -4)),
          p -> new Delay(p[0]),
          "subtract %s s from the track's times",
          true);

  @Override
  public double delayS(double delayS) {
    return delayS + lateS;
  }
}
