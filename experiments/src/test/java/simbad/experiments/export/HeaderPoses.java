package simbad.experiments.export;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** As many poses as a detection map has: 81 x 81 places, six headings each, in whole numbers. */
final class HeaderPoses {
  /** Reads all poses of its input as a diagnosed sensor does, in both forms. */
  static final String READ_NEXT_OF_ALL =
      """
      #include <stdio.h>
      #include "sonar.h"
      int main(void) {
        int x, z;
        long h;
        sonar_memory whole = {0, 0, 0};
        sonar_memory_m metres = {0, 0, 0};
        while (scanf("%d %d %ld", &x, &z, &h) == 3) {
          sonar_pose at;
          at.x_mm = (int16_t)x;
          at.z_mm = (int16_t)z;
          at.heading_cdeg = (int16_t)h;
          printf("%d %.6f\\n", sonar_read_next(&whole, at),
              (double)sonar_read_next_m(&metres, (float)x / 1000, (float)z / 1000,
                  (float)((double)h * 1.7453292519943e-4)));
        }
        return 0;
      }
      """;

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
