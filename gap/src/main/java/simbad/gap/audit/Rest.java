package simbad.gap.audit;

import java.util.Arrays;
import java.util.stream.IntStream;
import simbad.gap.fit.Robust;

/**
 * What ranges are off from the line that most of them follow over what the scene expects: a wrong
 * speed of sound and an offset are no matter of single readings.
 */
final class Rest {
  /** In standard deviations: so far off a reading is still right. */
  static final double CORE = 4;

  private static final double LEAST_SHARE = 0.7;

  private final double[] offM;
  private final double noiseM;

  /**
   * Lays the line.
   *
   * @param view the rows
   * @param line through the medians of what was read at each distance
   */
  Rest(AuditView view, RobustLine line) {
    boolean isLine =
        line.share() >= LEAST_SHARE && line.slope() > 0 && line.halfWidth() <= AuditView.AIR;
    double slope = isLine ? line.slope() : 1;
    double[] all = new double[view.size()];
    Arrays.setAll(all, i -> view.asM(i) - slope * view.expectedM(i));
    double[] known =
        IntStream.range(0, all.length)
            .filter(i -> !Double.isNaN(all[i]) && !view.isEverywhere(i))
            .mapToDouble(i -> all[i])
            .toArray();
    double middle = Robust.median(known);
    offM = Arrays.stream(all).map(off -> off - middle).toArray();
    double[] size = Arrays.stream(known).map(off -> Math.abs(off - middle)).toArray();
    double least = view.noiseM();
    double rough = 3 * Math.max(Robust.NORMAL_OVER_MAD * Robust.median(size), least);
    // The median of steps is a step; the mean square of what is no jump is finer.
    double square =
        Arrays.stream(size).filter(off -> off <= rough).map(off -> off * off).average().orElse(0);
    noiseM = Math.max(Math.sqrt(square), least);
  }

  /** Metres; NaN where no echo was read or expected. */
  double offM(int i) {
    return offM[i];
  }

  boolean isKnown(int i) {
    return !Double.isNaN(offM[i]);
  }

  /** Whether a reading is that of what the scene expects. */
  boolean isRight(int i) {
    return Math.abs(offM[i]) <= coreM();
  }

  boolean isOff(int i) {
    return Math.abs(offM[i]) > coreM();
  }

  double coreM() {
    return CORE * noiseM;
  }

  /** Standard deviation of readings about the line, metres. */
  double noiseM() {
    return noiseM;
  }

  /** Rows that are off, in the view's order. */
  IntStream off() {
    return IntStream.range(0, offM.length).filter(this::isOff);
  }
}
