package simbad.gap.audit;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a range may be a multiple of: a unit, or the way there and back.
 *
 * @param times how many times too long
 * @param words what was done
 * @param undo what to multiply with
 */
record Factor(double times, String words, double undo) {
  private static final double INCH_M = 0.0254;
  private static final double FOOT_M = 0.3048;

  /** Of ranges in metres, or of those in centimetres that were taken for metres' hundredths. */
  private static Stream<Factor> all() {
    return Stream.of(
        new Factor(1000, "millimetres written as metres", 0.001),
        new Factor(100, "centimetres written as metres", 0.01),
        new Factor(10, "decimetres written as metres, or a point that moved", 0.1),
        new Factor(0.1, "a decimal point that moved", 10),
        new Factor(0.01, "metres divided by 100 once too often", 100),
        new Factor(0.001, "metres divided by 1000 once too often", 1000),
        new Factor(1 / INCH_M, "inches written as metres", INCH_M),
        new Factor(1 / FOOT_M, "feet written as metres", FOOT_M),
        new Factor(FOOT_M, "metres taken for feet", 1 / FOOT_M),
        new Factor(2.54, "centimetres taken for inches", 1 / 2.54),
        new Factor(1 / 2.54, "inches taken for centimetres", 2.54),
        new Factor(2, "the way there and back, not divided by two", 0.5),
        new Factor(0.5, "the way divided by two twice", 2));
  }

  /** The one that a slope is nearest to, as well as the speed of sound is known. */
  static Optional<Factor> of(double slope) {
    return all().filter(factor -> Math.abs(slope / factor.times - 1) <= AuditView.AIR).findFirst();
  }

  /** Whether no wrong constant of sound-speed comes so far: a fifth to five times. */
  static boolean isBeyondSound(double slope) {
    double most = ConstantCheck.FACTOR * (1 + AuditView.AIR);
    return slope > most || slope < 1 / most;
  }
}
