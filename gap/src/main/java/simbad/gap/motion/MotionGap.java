package simbad.gap.motion;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Way;
import simbad.motion.forecast.Exertion;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.forecast.PinballLoss;
import simbad.motion.forecast.Spread;
import simbad.motion.forecast.Window;
import simbad.motion.forecast.Windows;

/**
 * The gap of motion: CRPS (continuous ranked probability scores) by 19 quantiles over windows of
 * 0.5, 2 and 5 s, on blocks that were not fitted, for each horizon and component.
 */
final class MotionGap {
  private static final int GROUPS = 20;

  /** Twice the mean pinball loss of 19 quantiles that are right, of a Gaussian, over its sigma. */
  private static final double GAUSSIAN = gaussian();

  private final List<MotionRun> runs;
  private final double[][] before = new double[3][3];
  private final double[][] after = new double[3][3];
  private final double[][][] sums = new double[GROUPS][2][9];
  private final double[] inside = new double[9];

  /** Of windows of half a second: what the nominal model scores, and the diagnosed one. */
  private List<Window> shortest = List.of();

  private double[][] shortBefore = new double[0][];
  private double[][] shortAfter = new double[0][];
  private int windows;

  private MotionGap(List<MotionRun> runs) {
    this.runs = runs;
  }

  /**
   * Scores two models.
   *
   * @param runs with the windows
   * @param nominal what was believed
   * @param folds the diagnosed chain as the blocks beside each fold say it
   */
  static MotionGap of(List<MotionRun> runs, MotionForecast nominal, List<MotionChain> folds) {
    MotionGap gap = new MotionGap(runs);
    double[] horizons = Windows.horizonsS();
    for (int h = 0; h < horizons.length; h++) {
      gap.score(h, Windows.of(runs, horizons[h]), nominal, folds);
    }
    return gap;
  }

  private void score(int h, List<Window> cut, MotionForecast nominal, List<MotionChain> folds) {
    double[][] plain = residuals(cut, nominal.chain());
    double[] asked = asked(cut);
    double[][] scoresBefore = new double[cut.size()][3];
    double[][] scoresAfter = new double[cut.size()][3];
    Spread believed = nominal.spreads().get(h);
    for (int fold = 0; fold < folds.size(); fold++) {
      double[][] own = residuals(cut, folds.get(fold));
      int left = fold;
      int[] others = IntStream.range(0, own.length).filter(i -> fold(cut.get(i)) != left).toArray();
      Spread spread = spread(asked, own, others);
      for (int i = 0; i < own.length; i++) {
        for (int c = 0; fold(cut.get(i)) == fold && c < 3; c++) {
          scoresBefore[i][c] = PinballLoss.crps(believed.at(asked[i], c), plain[i][c]);
          double[] quantiles = spread.at(asked[i], c);
          scoresAfter[i][c] = PinballLoss.crps(quantiles, own[i][c]);
          boolean in =
              own[i][c] >= quantiles[0] && own[i][c] <= quantiles[PinballLoss.QUANTILES - 1];
          inside[3 * h + c] += in ? 1.0 / own.length : 0;
        }
      }
    }
    gather(h, cut, scoresBefore, scoresAfter);
  }

  private static Spread spread(double[] asked, double[][] residuals, int[] of) {
    return Spread.of(
        Arrays.stream(of).mapToDouble(i -> asked[i]).toArray(),
        Arrays.stream(of).mapToObj(i -> residuals[i]).toArray(double[][]::new));
  }

  private void gather(int h, List<Window> cut, double[][] scoresBefore, double[][] scoresAfter) {
    for (int i = 0; i < cut.size(); i++) {
      int group = Math.floorMod((long) Math.floor(cut.get(i).startS() / 10), GROUPS);
      for (int c = 0; c < 3; c++) {
        sums[group][0][3 * h + c] += scoresBefore[i][c];
        sums[group][1][3 * h + c] += scoresAfter[i][c];
        before[h][c] += scoresBefore[i][c] / cut.size();
        after[h][c] += scoresAfter[i][c] / cut.size();
      }
    }
    if (h == 0) {
      shortest = cut;
      shortBefore = scoresBefore;
      shortAfter = scoresAfter;
      windows = cut.size();
    }
  }

  private static int fold(Window window) {
    return MotionSteps.fold(window.run(), window.startS());
  }

  private double[] asked(List<Window> cut) {
    List<Exertion> exertions = runs.stream().map(Exertion::of).toList();
    return cut.stream()
        .mapToDouble(w -> exertions.get(w.run()).between(w.startS(), w.endS()))
        .toArray();
  }

  private double[][] residuals(List<Window> cut, MotionChain chain) {
    List<Way> ways = MotionSteps.ways(runs, chain);
    double[][] residuals = new double[cut.size()][3];
    for (int i = 0; i < residuals.length; i++) {
      Window window = cut.get(i);
      Displacement expected = ways.get(window.run()).between(window.startS(), window.endS());
      for (int c = 0; c < 3; c++) {
        double off = window.way().component(c) - expected.component(c);
        residuals[i][c] = c == 2 ? MotionSteps.wrapped(off) : off;
      }
    }
    return residuals;
  }

  /** Returns a chain with how far it may be off on another drive. */
  static MotionForecast forecast(List<MotionRun> runs, MotionChain chain) {
    MotionGap own = new MotionGap(runs);
    return new MotionForecast(
        chain,
        Arrays.stream(Windows.horizonsS())
            .mapToObj(
                horizon -> {
                  List<Window> cut = Windows.of(runs, horizon);
                  return Spread.ofAnother(own.asked(cut), own.residuals(cut, chain));
                })
            .toList());
  }

  /** Returns the mean of the nine of a chain that was fitted to all, in units of the nominal. */
  double fitted(MotionChain chain) {
    double[] horizons = Windows.horizonsS();
    double sum = 0;
    for (int h = 0; h < horizons.length; h++) {
      List<Window> cut = Windows.of(runs, horizons[h]);
      double[][] residuals = residuals(cut, chain);
      double[] asked = asked(cut);
      Spread spread = Spread.of(asked, residuals);
      for (int c = 0; c < 3; c++) {
        double own = 0;
        for (int i = 0; i < residuals.length; i++) {
          own += PinballLoss.crps(spread.at(asked[i], c), residuals[i][c]);
        }
        sum += before[h][c] > 0 ? own / residuals.length / before[h][c] / 9 : 1.0 / 9;
      }
    }
    return sum;
  }

  double[][] before() {
    return before;
  }

  double[][] after() {
    return after;
  }

  int windows() {
    return windows;
  }

  /** Returns the share of values within forecasts of 90 %, by horizon and component. */
  double[][] coverage() {
    return new double[][] {
      Arrays.copyOfRange(inside, 0, 3),
      Arrays.copyOfRange(inside, 3, 6),
      Arrays.copyOfRange(inside, 6, 9)
    };
  }

  List<Window> shortest() {
    return shortest;
  }

  double[][] shortBefore() {
    return shortBefore;
  }

  double[][] shortAfter() {
    return shortAfter;
  }

  /** Returns the gap after: the mean of the nine, each in units of its nominal value. */
  double ratio() {
    return ratio(-1);
  }

  /** Returns where the ratio would lie 19 times of 20, by leaving out a twentieth at a time. */
  Interval ci95() {
    double ratio = ratio();
    double square = 0;
    for (int group = 0; group < GROUPS; group++) {
      double off = ratio(group) - ratio;
      square += off * off * (GROUPS - 1) / GROUPS;
    }
    double half = NormalChance.NORMAL_95 * Math.sqrt(square);
    return new Interval(ratio - half, ratio + half);
  }

  /**
   * Returns where the ratio would lie on another drive of the robot, 19 times of 20: what is left
   * of the gap differs by a factor, for other commands bring out other causes.
   *
   * @param otherDrive logarithm of that factor
   */
  Interval onAnotherDrive95(double otherDrive) {
    double ratio = ratio();
    if (ratio == 0) {
      return new Interval(0, 0);
    }
    double factor = Math.exp(Math.hypot(otherDrive, (ci95().high() - ratio) / ratio));
    return new Interval(ratio / factor, ratio * factor);
  }

  private double ratio(int leftOut) {
    double sum = 0;
    int parts = 0;
    for (int k = 0; k < 9; k++) {
      double nominal = 0;
      double diagnosed = 0;
      for (int group = 0; group < GROUPS; group++) {
        nominal += group == leftOut ? 0 : sums[group][0][k];
        diagnosed += group == leftOut ? 0 : sums[group][1][k];
      }
      if (nominal > 0) {
        sum += diagnosed / nominal;
        parts++;
      }
    }
    return parts == 0 ? 1 : sum / parts;
  }

  /** Returns the gap that a noise alone would leave, in units of the nominal. */
  double floor(Noise[] noises) {
    double[] horizons = Windows.horizonsS();
    double sum = 0;
    for (int h = 0; h < horizons.length; h++) {
      for (int c = 0; c < 3; c++) {
        double own = GAUSSIAN * Math.sqrt(noises[c].variance(horizons[h], 1));
        sum += before[h][c] > 0 ? Math.min(1, own / before[h][c]) / 9 : 1.0 / 9;
      }
    }
    return sum;
  }

  /** At a level the pinball loss of a right quantile is the density there. */
  private static double gaussian() {
    double sum = 0;
    for (int q = 0; q < PinballLoss.QUANTILES; q++) {
      double deviate = NormalChance.deviate(PinballLoss.level(q));
      sum += 2 * Math.exp(-deviate * deviate / 2) / Math.sqrt(2 * Math.PI) / PinballLoss.QUANTILES;
    }
    return sum;
  }
}
