package simbad.scattering;

/**
 * What a ranger's sender, receiver and comparator make of echoes, all told.
 *
 * @param levelDb by how much the echo of a target of |f| = 1 sqrt(m) at 1 m in air without loss
 *     exceeds the comparator's final threshold
 * @param desensitisation K: by how much more than its final value the threshold stands at the
 *     burst, as a multiple; at least 0
 * @param recoveryS time in which that falls to a share of 1/e, seconds, positive
 */
public record Receiver(double levelDb, double desensitisation, double recoveryS) {
  /** Checks every figure. */
  public Receiver {
    require(Math.abs(levelDb) < Double.POSITIVE_INFINITY, "levelDb", levelDb, "finite");
    require(
        desensitisation >= 0 && desensitisation < Double.POSITIVE_INFINITY,
        "desensitisation",
        desensitisation,
        "in [0, infinity)");
    require(
        recoveryS > 0 && recoveryS < Double.POSITIVE_INFINITY,
        "recoveryS",
        recoveryS,
        "in (0, infinity)");
  }

  private static void require(boolean holds, String name, double value, String permitted) {
    if (!holds) {
      throw new IllegalArgumentException(name + " = " + value + " is not " + permitted);
    }
  }
}
