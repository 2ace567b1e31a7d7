package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Echoes lose strength with the length of their way, so that far thresholds shrink more.
 *
 * @param perM loss for each metre; 0 is neutral; negative where the air absorbs less than believed
 * @param law how the loss acts
 */
public record Absorption(double perM, Law law) implements ThresholdChange {
  /** How a threshold T shrinks under a loss a. */
  public enum Law {
    /** T exp(-a T). */
    EXPONENTIAL,
    /** T / (1 + a T). */
    HYPERBOLIC,
    /** The solution t of t exp(a t) = T: spreading and absorption together keep their level. */
    BALANCED
  }

  /** Newton's steps to the balance; it converges quadratically. */
  private static final int STEPS = 6;

  /** Where less is absorbed than believed, a hyperbolic law would leave all distances behind. */
  private static final double GREATEST_FACTOR = 20;

  /** Checks the figure; NaN is refused. */
  public Absorption {
    Checks.finite("perM", perM);
  }

  @Override
  public double factor(Geometry geometry, int line) {
    double loss = perM * geometry.thresholdM(line);
    if (loss == 0) {
      return 1;
    }
    return switch (law) {
      case EXPONENTIAL -> Math.exp(-loss);
      case HYPERBOLIC -> 1 / Math.max(1 / GREATEST_FACTOR, 1 + loss);
      case BALANCED -> loss > 0 ? balance(loss) : Math.exp(-loss);
    };
  }

  /** The solution u of u exp(loss u) = 1. */
  private static double balance(double loss) {
    double u = 1 / (1 + loss);
    for (int i = 0; i < STEPS; i++) {
      u -= (Math.log(u) + loss * u) / (1 / u + loss);
    }
    return u;
  }
}
