package simbad.blindworld.generate;

import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.Windows;

/** How plainly a track speaks for one forecast of its windows against another. */
final class MotionEvidence {

  /** Windows begin every half second and last up to five: a block is of ten seconds. */
  private static final double BLOCK_S = 10;

  private MotionEvidence() {}

  /**
   * The gain of a forecast over a rival.
   *
   * @param share of the rival's losses, averaged over horizons and components
   * @param standardErrors the gain over its standard error, from means over blocks of ten seconds
   */
  record Gain(double share, double standardErrors) {}

  static Gain of(MotionForecast better, MotionForecast rival, Windows windows, double[][] shown) {
    double[] units = rival.losses(windows, shown);
    double sum = 0;
    double squares = 0;
    int blocks = 0;
    double block = 0;
    int inBlock = 0;
    for (int i = 0; i < windows.size(); i++) {
      for (int c = 0; c < Windows.COMPONENTS; c++) {
        double unit = units[windows.at(i).horizon() * Windows.COMPONENTS + c];
        double gain = rival.loss(i, c, shown[i][c]) - better.loss(i, c, shown[i][c]);
        block += unit > 0 ? gain / unit : 0;
        inBlock++;
      }
      if (i + 1 == windows.size() || blockOf(windows, i + 1) != blockOf(windows, i)) {
        sum += block / inBlock;
        squares += block / inBlock * (block / inBlock);
        blocks++;
        block = 0;
        inBlock = 0;
      }
    }
    double mean = sum / Math.max(1, blocks);
    double variance = Math.max(0, squares / Math.max(1, blocks) - mean * mean);
    double error = Math.sqrt(variance / Math.max(1, blocks - 1));
    return new Gain(mean, error > 0 ? mean / error : 0);
  }

  private static long blockOf(Windows windows, int index) {
    Windows.Window window = windows.at(index);
    return 1_000_000L * window.run() + (long) Math.floor(window.beginS() / BLOCK_S);
  }
}
