package simbad.gap.design;

import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.scene.SensingSetup;

/**
 * How much a reading is expected to say for one of two distributions, if that one is true: the
 * divergence of Kullback and Leibler (1951) over no-echo and the steps of the sensor's resolution.
 *
 * <p>Both are mixed with a little of everything, as in a likelihood: nothing is impossible.
 */
final class Divergence {
  private static final double BROAD = 1e-3;
  private static final double BROAD_NO_ECHO = 0.3;
  private static final double FINEST_STEP_M = 5e-3;

  /** What holds less than this in both says nothing. */
  private static final double HARDLY = 1e-5;

  private final double stepM;
  private final int steps;
  private final double broadStep;

  /** Creates one for the readings of a set-up, in the steps of its resolution. */
  Divergence(SensingSetup setup) {
    this(setup, 0);
  }

  /**
   * Creates one that sees no difference within a step: it says at most as much, and sooner.
   *
   * @param leastStepM metres
   */
  Divergence(SensingSetup setup, double leastStepM) {
    double resolution = setup.sensor().resolutionM();
    stepM = Math.max(leastStepM, resolution > 0 ? resolution : FINEST_STEP_M);
    // Ranges may come out longer than the longest distance.
    steps = (int) Math.ceil(1.5 * setup.sensor().maxRangeM() / stepM);
    broadStep = BROAD * (1 - BROAD_NO_ECHO) / steps;
  }

  /**
   * Both directions at once.
   *
   * @param forOne expected nats for the first if it is true, at least 0
   * @param forOther expected nats for the second if it is true
   */
  record Nats(double forOne, double forOther) {
    static final Nats NONE = new Nats(0, 0);

    Nats plus(Nats more) {
      return new Nats(forOne + more.forOne, forOther + more.forOther);
    }

    double least() {
      return Math.min(forOne, forOther);
    }
  }

  /** Computes the expected nats of a reading. */
  Nats between(ReadingDistribution one, ReadingDistribution other) {
    Nats silence = nats(one.noEchoProbability(), other.noEchoProbability(), BROAD * BROAD_NO_ECHO);
    return silence.plus(within(one, other, new Span(0, steps, upTo(one, -1), upTo(other, -1))));
  }

  /** Steps [from, to), and what lies below them in both. */
  private record Span(int from, int to, double belowOne, double belowOther) {}

  private Nats within(ReadingDistribution one, ReadingDistribution other, Span span) {
    double endOne = upTo(one, span.to() - 1);
    double endOther = upTo(other, span.to() - 1);
    double p = endOne - span.belowOne();
    double q = endOther - span.belowOther();
    if (p < HARDLY && q < HARDLY) {
      return Nats.NONE;
    }
    if (span.to() - span.from() == 1) {
      return nats(Math.max(0, p), Math.max(0, q), broadStep);
    }
    int middle = (span.from() + span.to()) >>> 1;
    Nats lower =
        within(one, other, new Span(span.from(), middle, span.belowOne(), span.belowOther()));
    Span upper = new Span(middle, span.to(), upTo(one, middle - 1), upTo(other, middle - 1));
    return lower.plus(within(one, other, upper));
  }

  private double upTo(ReadingDistribution distribution, int step) {
    return step < 0 ? 0 : distribution.echoUpTo((step + 0.5) * stepM);
  }

  private static Nats nats(double p, double q, double broad) {
    double one = (1 - BROAD) * p + broad;
    double other = (1 - BROAD) * q + broad;
    double odds = Math.log(one / other);
    return new Nats(one * odds, -other * odds);
  }
}
