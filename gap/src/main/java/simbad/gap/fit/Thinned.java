package simbad.gap.fit;

import java.util.Random;

/** One of so many pings, anywhere in a log: no pattern of a scan hides between them. */
final class Thinned implements Fold {
  private static final long SEED = 271_828;

  private final boolean[] holds;

  /**
   * Chooses pings, the same ones each time.
   *
   * @param pings of the log
   * @param of each group of so many that follow each other, one is taken
   */
  Thinned(int pings, int of) {
    holds = new boolean[pings];
    Random random = new Random(SEED);
    for (int first = 0; first < pings; first += of) {
      holds[Math.min(pings - 1, first + random.nextInt(of))] = true;
    }
  }

  @Override
  public boolean holds(int ping) {
    return holds[ping];
  }
}
