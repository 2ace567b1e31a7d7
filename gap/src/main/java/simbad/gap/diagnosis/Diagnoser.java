package simbad.gap.diagnosis;

import java.util.Set;
import simbad.sonar.effect.Effect;

/** Diagnoses data sets. Deterministic: the same data set and seed give the same diagnosis. */
public final class Diagnoser {
  private final long seed;
  private final Set<Effect> withheld;

  /**
   * Creates a diagnoser.
   *
   * @param seed of what is resampled
   * @param withheld effects that it shall not know, for checks of what it calls unknown
   */
  public Diagnoser(long seed, Set<Effect> withheld) {
    this.seed = seed;
    this.withheld = Set.copyOf(withheld);
  }

  /** Diagnoses a data set. */
  public Diagnosis diagnose(DataSet data) {
    throw new UnsupportedOperationException("seed " + seed + ", without " + withheld + ": " + data);
  }
}
