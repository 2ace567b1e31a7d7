package simbad.experiments.export;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** As many poses as a detection map has: 81 x 81 places, six headings each, in whole numbers. */
final class HeaderPoses {
  private static final int CELLS = 81;
  private static final int HEADINGS = 6;

  private HeaderPoses() {}

  /** Each x and z in millimetres, and a heading in hundredths of a degree. */
  static List<int[]> all(double reachM, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<int[]> poses = new ArrayList<>();
    for (int cell = 0; cell < CELLS * CELLS; cell++) {
      int x = place(cell % CELLS, reachM);
      int z = place(cell / CELLS, reachM);
      for (int i = 0; i < HEADINGS; i++) {
        poses.add(new int[] {x, z, random.nextInt(-18_000, 18_001)});
      }
    }
    return poses;
  }

  private static int place(int cell, double reachM) {
    return (int) Math.rint(1000 * reachM * (2.0 * cell / (CELLS - 1) - 1));
  }
}
