package simbad.blindworld.wave;

import java.util.ArrayList;
import java.util.List;

/** What one ping brings, by reflector, at those carrier cycles at which it may be heard. */
final class Sound {

  private static final double SILENT_DB = -99;

  private final int[] cycles;
  private final double[][] re;
  private final double[][] im;
  private final double excessDb;

  /**
   * The sound of echoes that are drawn out already.
   *
   * @param echoes one for each reflector
   * @param headroom by which factor they may be greater on a ping
   */
  Sound(List<Trace> echoes, Detector detector, double headroom) {
    List<Integer> heard = new ArrayList<>();
    int from = echoes.stream().mapToInt(Trace::first).min().orElse(0);
    int to = echoes.stream().mapToInt(e -> e.first() + e.length()).max().orElse(0);
    double most = 0;
    for (int cycle = Math.max(detector.armed(), from);
        cycle < to && cycle <= detector.end();
        cycle++) {
      double sumRe = 0;
      double sumIm = 0;
      double sizes = 0;
      for (Trace echo : echoes) {
        double x = echo.re(cycle);
        double y = echo.im(cycle);
        sumRe += x;
        sumIm += y;
        sizes += Math.sqrt(x * x + y * y);
      }
      most = Math.max(most, StrictMath.hypot(sumRe, sumIm) / detector.threshold(cycle));
      if (detector.mayHear(headroom * sizes, cycle)) {
        heard.add(cycle);
      }
    }
    cycles = heard.stream().mapToInt(Integer::intValue).toArray();
    re = new double[echoes.size()][cycles.length];
    im = new double[echoes.size()][cycles.length];
    for (int e = 0; e < re.length; e++) {
      for (int i = 0; i < cycles.length; i++) {
        re[e][i] = echoes.get(e).re(cycles[i]);
        im[e][i] = echoes.get(e).im(cycles[i]);
      }
    }
    excessDb = most > 0 ? 20 * StrictMath.log10(most) : SILENT_DB;
  }

  int size() {
    return cycles.length;
  }

  int cycle(int i) {
    return cycles[i];
  }

  /** The greatest level over the threshold, without noise, in decibels. */
  double excessDb() {
    return Math.max(SILENT_DB, excessDb);
  }

  double re(int i, Complex[] factors) {
    double sum = 0;
    for (int e = 0; e < re.length; e++) {
      sum += re[e][i] * factors[e].re() - im[e][i] * factors[e].im();
    }
    return sum;
  }

  double im(int i, Complex[] factors) {
    double sum = 0;
    for (int e = 0; e < re.length; e++) {
      sum += re[e][i] * factors[e].im() + im[e][i] * factors[e].re();
    }
    return sum;
  }
}
