package simbad.sonar.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.random.RandomGenerator;
import simbad.sonar.check.Checks;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;

/**
 * The distribution of one reading: some probability of no echo, the rest spread over the distances
 * that may answer, each with Gaussian noise and rounded down to the sensor's resolution.
 *
 * <p>A reading that noise would take below 0 is 0. Immutable.
 */
public final class ReadingDistribution {
  /** Further than any echo: quantiles below it are those of the echoes alone. */
  private static final double BEYOND_M = 1e4;

  private static final double LEAST_SHARE = 1e-6;

  private final Part[] parts;
  private final double noEchoProbability;
  private final double resolutionM;
  private final Report report;

  /**
   * Creates a distribution.
   *
   * @param parts their shares add up to at most 1; what is left is no echo
   * @param resolutionM step of the ranges reported, metres; 0 for none
   * @param report how a measured range is reported
   */
  public ReadingDistribution(List<Part> parts, double resolutionM, Report report) {
    this.parts = parts.toArray(Part[]::new);
    this.resolutionM = Checks.notNegative("resolutionM", resolutionM);
    this.report = report;
    double heard = 0;
    for (Part part : parts) {
      heard += part.share();
    }
    noEchoProbability = Math.max(0, 1 - heard);
  }

  /** Of obstacles that may answer, nearest first: each is read when no nearer one answers. */
  static ReadingDistribution nearestFirst(List<Sight> heard, double noiseM, double resolutionM) {
    List<Part> parts = new ArrayList<>();
    double silent = 1;
    for (Sight sight : heard) {
      parts.add(
          new Part(sight.nearestM().orElseThrow(), noiseM, 0, silent * sight.echoProbability()));
      silent *= 1 - sight.echoProbability();
    }
    return new ReadingDistribution(parts, resolutionM, Report.AS_MEASURED);
  }

  /**
   * Returns what is read if one of several distributions holds, and nobody knows which.
   *
   * @param others of the same sensor, with this one's resolution and way of reporting
   * @param shares how probable each of the others is, at least 0 and in all at most 1; this one has
   *     the rest
   */
  public ReadingDistribution mixed(List<ReadingDistribution> others, double... shares) {
    List<Part> mixed = new ArrayList<>();
    double rest = 1;
    for (int i = 0; i < shares.length; i++) {
      rest -= Checks.notNegative("share", shares[i]);
      others.get(i).addParts(shares[i], mixed);
    }
    addParts(Checks.notNegative("share of the first", rest), mixed);
    return new ReadingDistribution(mixed, resolutionM, report);
  }

  private void addParts(double share, List<Part> into) {
    for (Part part : parts) {
      into.add(new Part(part.meanM(), part.deviationM(), part.halfWidthM(), share * part.share()));
    }
  }

  /**
   * Returns the expectation of a figure of the reading. Single ranges that may come for sure, such
   * as a number for "no echo", count each by itself, and so does no echo; what is spread is taken
   * at the middles of equal shares.
   *
   * @param figure of a range, metres
   * @param noEchoM the range that a no-echo counts as, metres
   * @param shares how many, at least 1
   */
  public double expected(DoubleUnaryOperator figure, double noEchoM, int shares) {
    double sum = noEchoProbability * figure.applyAsDouble(noEchoM);
    List<Part> spread = new ArrayList<>();
    double spreadShare = 0;
    for (Part part : parts) {
      if (part.isPoint()) {
        double rangeM = Math.max(0, roundedDown(report.reported(part.meanM())));
        sum += part.share() * figure.applyAsDouble(rangeM);
      } else {
        spread.add(part);
        spreadShare += part.share();
      }
    }
    double each = spreadShare / shares;
    if (each > LEAST_SHARE) {
      double[] levels = new double[shares];
      Arrays.setAll(levels, i -> (i + 0.5) * each);
      ReadingDistribution others =
          spread.size() == parts.length
              ? this
              : new ReadingDistribution(spread, resolutionM, report);
      for (double rangeM : others.quantilesM(levels, BEYOND_M)) {
        sum += each * figure.applyAsDouble(rangeM);
      }
    }
    return sum;
  }

  /** Returns the probability of no echo, in [0, 1]. */
  public double noEchoProbability() {
    return noEchoProbability;
  }

  /**
   * Returns the probability of an echo that reads at most a range.
   *
   * @param rangeM metres, any number, infinity included
   * @return in [0, 1 - noEchoProbability]
   */
  public double echoUpTo(double rangeM) {
    Checks.number("rangeM", rangeM);
    if (rangeM < 0) {
      return 0;
    }
    double sum = 0;
    for (Part part : parts) {
      sum += part.share() * readsUpTo(rangeM, part);
    }
    return sum;
  }

  /** The probability that what answers from a distance reads at most a range. */
  private double readsUpTo(double rangeM, Part part) {
    if (part.isPoint()) {
      return roundedDown(report.reported(part.meanM())) <= roundedDown(rangeM) ? 1 : 0;
    }
    // All that is rounded down to this range lies below the next step.
    double below = resolutionM > 0 ? (stepOf(rangeM) + 1) * resolutionM : rangeM;
    return part.below(report.leastRange(below));
  }

  /**
   * Returns the probability that an echo falls into the step of the resolution that holds a range.
   *
   * @param rangeM metres, at least 0
   * @throws IllegalStateException if the sensor has no resolution, for then each single range has
   *     probability 0
   */
  public double probabilityOfStep(double rangeM) {
    if (!(resolutionM > 0)) {
      throw new IllegalStateException("resolutionM = 0: a single range has probability 0");
    }
    Checks.number("rangeM", rangeM);
    double step = stepOf(rangeM);
    return echoUpTo((step + 0.5) * resolutionM) - echoUpTo((step - 0.5) * resolutionM);
  }

  /**
   * Returns a quantile of the reading, no-echo counted as a range: the least range that is not
   * exceeded with at least the given probability.
   *
   * @param level in (0, 1)
   * @param noEchoM the range that a no-echo counts as, metres
   * @return metres
   */
  public double quantileM(double level, double noEchoM) {
    return quantilesM(new double[] {level}, noEchoM)[0];
  }

  /**
   * Returns several quantiles of the reading, faster than one after the other.
   *
   * @param levels in (0, 1), ascending
   * @param noEchoM the range that a no-echo counts as, metres
   * @return as {@link #quantileM} returns for each level, metres
   */
  public double[] quantilesM(double[] levels, double noEchoM) {
    Checks.number("noEchoM", noEchoM);
    double upToNoEcho = echoUpTo(noEchoM);
    double[] quantilesM = new double[levels.length];
    long step = 0;
    for (int i = 0; i < levels.length; i++) {
      double level = levels[i];
      if (!(level > 0 && level < 1)) {
        throw new IllegalArgumentException("level = " + level + " is not in (0, 1)");
      }
      boolean near = upToNoEcho >= level && noEchoM > 0;
      if (!near && upToNoEcho + noEchoProbability >= level) {
        quantilesM[i] = noEchoM;
        continue;
      }
      double reached = near ? level : level - noEchoProbability;
      double echoM;
      if (resolutionM > 0) {
        step = stepQuantile(reached, step);
        echoM = step * resolutionM;
      } else {
        echoM = freeQuantileM(reached);
      }
      quantilesM[i] = near ? Math.min(echoM, noEchoM) : echoM;
    }
    return quantilesM;
  }

  /**
   * The least step that reaches a probability that echoes do reach: a reading has no other values.
   *
   * @param from a step that is not beyond it
   */
  private long stepQuantile(double reached, long from) {
    long low = from - 1;
    long high = from;
    for (long stride = 1; upToStep(high) < reached && high < Long.MAX_VALUE / 4; stride *= 2) {
      low = high;
      high += stride;
    }
    while (high - low > 1) {
      long middle = (low + high) >>> 1;
      if (upToStep(middle) >= reached) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return high;
  }

  private double upToStep(long step) {
    return echoUpTo(step * resolutionM);
  }

  private double freeQuantileM(double reached) {
    double low = 0;
    double high = 1;
    while (echoUpTo(high) < reached && high < Double.MAX_VALUE / 2) {
      low = high;
      high *= 2;
    }
    for (int i = 0; i < 200 && Math.nextUp(low) < high; i++) {
      double middle = (low + high) / 2;
      if (echoUpTo(middle) >= reached) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return roundedDown(high);
  }

  /** Draws a reading. */
  public Reading sample(RandomGenerator random) {
    double draw = random.nextDouble();
    double gauss = isNoisy() ? NormalDistribution.draw(random) : 0;
    for (Part part : parts) {
      draw -= part.share();
      if (draw < 0) {
        double even = part.halfWidthM() > 0 ? 2 * random.nextDouble() - 1 : 0;
        double range = part.meanM() + part.deviationM() * gauss + part.halfWidthM() * even;
        return new Echo(Math.max(0, roundedDown(report.reported(range))));
      }
    }
    return NoEcho.NO_ECHO;
  }

  private boolean isNoisy() {
    for (Part part : parts) {
      if (part.deviationM() > 0) {
        return true;
      }
    }
    return false;
  }

  private double stepOf(double rangeM) {
    return stepOf(rangeM, resolutionM);
  }

  private double roundedDown(double rangeM) {
    return roundedDown(rangeM, resolutionM);
  }

  private static double stepOf(double rangeM, double resolutionM) {
    // A range that was written with few decimals lies a rounding error beside its step.
    return Math.floor(rangeM / resolutionM + 1e-9);
  }

  /** Rounds a range down to a sensor's resolution; 0 for none. */
  static double roundedDown(double rangeM, double resolutionM) {
    return resolutionM > 0 ? stepOf(rangeM, resolutionM) * resolutionM : rangeM;
  }
}
