package simbad.gap.search;

import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import simbad.sonar.change.RangeSwing;

/**
 * Looks for a period with which ranges swing, by a periodogram of how much likelier each reading
 * would be if it read longer (least squares at each frequency, Scargle 1982).
 */
final class Swinging {
  /** What swings as often while a log is taken is no drift. */
  private static final double LEAST_SWINGS = 50;

  private static final double SHORTEST_S = 0.3;

  /** Of faster swings a slower one reads the same now and then. */
  private static final double LEAST_PINGS = 4;

  /** Steps of the frequency: shares of what a log of this length can tell apart. */
  private static final double STEP_SHARE = 0.25;

  private final double[] perMetre;
  private final IntToDoubleFunction timeS;
  private final double durationS;

  /**
   * Creates it for a log.
   *
   * @param perMetre by how much the log probability of each reading rises with its range, 1/m
   * @param timeS of each ping since the first, seconds
   * @param durationS of the log, seconds; 0 where nothing can be said of time
   */
  Swinging(double[] perMetre, IntToDoubleFunction timeS, double durationS) {
    this.perMetre = perMetre;
    this.timeS = timeS;
    this.durationS = durationS;
  }

  /**
   * What was found.
   *
   * @param swing with its period
   * @param choiceNats what choosing the period costs: there are as many that differ
   */
  record Found(RangeSwing swing, double choiceNats) {}

  /**
   * Returns the likeliest swing, by a parabola of the likelihood about none; empty where the log is
   * too short for any, or where nothing swings.
   */
  Optional<Found> likeliest() {
    double mostSwings = Math.min(durationS / SHORTEST_S, perMetre.length / LEAST_PINGS);
    Optional<RangeSwing> best = Optional.empty();
    double most = 0;
    for (double swings = LEAST_SWINGS; swings < mostSwings; swings += STEP_SHARE) {
      Sums sums = new Sums(durationS / swings);
      if (sums.nats() > most) {
        most = sums.nats();
        best = Optional.of(sums.swing());
      }
    }
    return best.map(swing -> new Found(swing, Math.log(Math.max(1, mostSwings - LEAST_SWINGS))));
  }

  /** Of one period: the scores' sums with its sine and cosine, and their second moments. */
  private final class Sums {
    private final double periodS;
    private final double sine;
    private final double cosine;
    private final double sineSine;
    private final double cosineCosine;
    private final double both;

    Sums(double periodS) {
      this.periodS = periodS;
      double ofSine = 0;
      double ofCosine = 0;
      double ofSineSine = 0;
      double ofCosineCosine = 0;
      double ofBoth = 0;
      for (int i = 0; i < perMetre.length; i++) {
        if (perMetre[i] != 0) {
          double angleRad = 2 * Math.PI * timeS.applyAsDouble(i) / periodS;
          double s = perMetre[i] * Math.sin(angleRad);
          double c = perMetre[i] * Math.cos(angleRad);
          ofSine += s;
          ofCosine += c;
          ofSineSine += s * s;
          ofCosineCosine += c * c;
          ofBoth += s * c;
        }
      }
      sine = ofSine;
      cosine = ofCosine;
      sineSine = ofSineSine;
      cosineCosine = ofCosineCosine;
      both = ofBoth;
    }

    private double determinant() {
      return sineSine * cosineCosine - both * both;
    }

    RangeSwing swing() {
      return new RangeSwing(
          (cosineCosine * sine - both * cosine) / determinant(),
          (sineSine * cosine - both * sine) / determinant(),
          periodS);
    }

    /** What it gains; nothing where all readings are at one place of the swing. */
    double nats() {
      if (!(determinant() > 1e-9 * sineSine * cosineCosine)) {
        return 0;
      }
      RangeSwing swing = swing();
      return (sine * swing.sineM() + cosine * swing.cosineM()) / 2;
    }
  }
}
