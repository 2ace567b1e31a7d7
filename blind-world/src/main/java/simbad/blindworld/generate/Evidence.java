package simbad.blindworld.generate;

import simbad.blindworld.world.Forecast;

/** How plainly readings speak for one forecast against another. */
final class Evidence {

  private static final int BLOCK = 20;

  private Evidence() {}

  /**
   * The gain of a forecast over a rival, and how many standard errors that is, from means over
   * blocks of neighbouring rows.
   *
   * @param gainCm by how much the gap is less
   * @param standardErrors the gain over its standard error
   */
  record Gain(double gainCm, double standardErrors) {}

  static Gain of(Forecast better, Forecast rival, double[] readingsM, double noEchoM) {
    int blocks = readingsM.length / BLOCK;
    double sum = 0;
    double squares = 0;
    for (int b = 0; b < blocks; b++) {
      double block = 0;
      for (int row = b * BLOCK; row < (b + 1) * BLOCK; row++) {
        double counted = readingsM[row] < Double.POSITIVE_INFINITY ? readingsM[row] : noEchoM;
        block += rival.lossCm(row, counted) - better.lossCm(row, counted);
      }
      sum += block / BLOCK;
      squares += block / BLOCK * (block / BLOCK);
    }
    double mean = sum / blocks;
    double variance = Math.max(0, squares / blocks - mean * mean);
    double error = Math.sqrt(variance / blocks);
    return new Gain(mean, error > 0 ? mean / error : 0);
  }
}
