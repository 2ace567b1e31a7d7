package simbad.bench.capture;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import simbad.sonar.check.Checks;

/**
 * The threshold that levels speak for: where the chance of an echo is half of what it is near by,
 * the chance being 1 / (1 + exp((r - T) / w)) as in the nominal model.
 *
 * @param thresholdM T of the greatest likelihood, the middle where many are as likely; metres
 * @param lowM lower end of its 95 % interval, by the profile of the likelihood; never nearer than
 *     the last distance at which all was heard
 * @param highM upper end
 * @param outM furthest distance heard on the way out, less where none was
 * @param inM furthest distance heard on the way in
 * @param pings how many went into it
 */
public record ThresholdFit(
    double thresholdM, double lowM, double highM, double outM, double inM, int pings) {
  /** Checks that all are numbers. */
  public ThresholdFit {
    Checks.number("thresholdM", thresholdM);
    Checks.number("lowM", lowM);
    Checks.number("highM", highM);
    Checks.number("outM", outM);
    Checks.number("inM", inM);
  }

  private static final double GRID_M = 0.001;
  private static final double[] WIDTHS_M = {0.001, 0.002, 0.004, 0.008, 0.012, 0.02, 0.03, 0.05};

  /** An echo now and then is missed, or heard, for no reason of distance. */
  private static final double MISS_RATE = 0.02;

  private static final double CHANCE_RATE = 0.005;

  /** Half of the 95 % quantile of chi squared with one degree of freedom. */
  private static final double DROP = 1.9207;

  private static final double AS_LIKELY = 0.02;

  /**
   * Estimates the threshold.
   *
   * @param levels of one bearing, at least one
   * @param plan says what counts as lost
   */
  public static ThresholdFit of(List<Level> levels, SweepPlan plan) {
    if (levels.isEmpty()) {
      throw new IllegalArgumentException("no levels");
    }
    double fromM = Math.max(0, extreme(levels, -1) - plan.stepM());
    double toM = extreme(levels, 1) + plan.stepM();
    int size = (int) Math.ceil((toM - fromM) / GRID_M) + 1;
    double[] likelihood = new double[size];
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      likelihood[i] = greatest(levels, fromM + i * GRID_M);
      best = Math.max(best, likelihood[i]);
    }
    double[] middle = within(likelihood, best - AS_LIKELY, fromM);
    double[] interval = within(likelihood, best - DROP, fromM);
    double thresholdM = (middle[0] + middle[1]) / 2;
    return new ThresholdFit(
        thresholdM,
        Math.min(interval[0], neighbour(levels, thresholdM, -1).orElse(0)),
        Math.max(interval[1], neighbour(levels, thresholdM, 1).orElse(toM)),
        furthest(levels, Approach.OUT, plan),
        furthest(levels, Approach.IN, plan),
        levels.stream().mapToInt(Level::pings).sum());
  }

  private static double extreme(List<Level> levels, int sign) {
    return levels.stream().mapToDouble(level -> sign * level.distanceM()).max().orElse(0) * sign;
  }

  /** The log likelihood at a threshold with the width that suits it best. */
  private static double greatest(List<Level> levels, double thresholdM) {
    double best = Double.NEGATIVE_INFINITY;
    for (double width : WIDTHS_M) {
      double sum = 0;
      for (Level level : levels) {
        double near = 1 / (1 + Math.exp((level.distanceM() - thresholdM) / width));
        double chance = CHANCE_RATE + (1 - MISS_RATE - CHANCE_RATE) * near;
        sum +=
            level.heard() * Math.log(chance)
                + (level.pings() - level.heard()) * Math.log(1 - chance);
      }
      best = Math.max(best, sum);
    }
    return best;
  }

  /** First and last threshold that is at least so likely. */
  private static double[] within(double[] likelihood, double least, double fromM) {
    int first = 0;
    while (likelihood[first] < least) {
      first++;
    }
    int last = likelihood.length - 1;
    while (likelihood[last] < least) {
      last--;
    }
    return new double[] {fromM + first * GRID_M, fromM + last * GRID_M};
  }

  /** The nearest level on one side. Between two levels nothing was asked. */
  private static OptionalDouble neighbour(List<Level> levels, double thresholdM, int sign) {
    return levels.stream()
        .filter(level -> (level.distanceM() - thresholdM) * sign > 0)
        .min(Comparator.comparingDouble(level -> Math.abs(level.distanceM() - thresholdM)))
        .stream()
        .mapToDouble(Level::distanceM)
        .findFirst();
  }

  private static double furthest(List<Level> levels, Approach approach, SweepPlan plan) {
    return levels.stream()
        .filter(level -> level.approach() == approach && !plan.isLost(level))
        .mapToDouble(Level::distanceM)
        .max()
        .orElse(0);
  }

  /** Returns it for people, in metres with its interval. */
  public String text() {
    return String.format(
        Locale.ROOT, "%.3f m [%.3f, %.3f], %d pings", thresholdM, lowM, highM, pings);
  }
}
