package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * How late commands act from one short stretch to the next. A clock or a controller makes each as
 * late as the others, or each by chance; a link that clogs makes all of them late for some seconds.
 */
final class Lateness {
  private static final double STRETCH_S = 1.5;

  /** Stretches are compared with those up to so many before. */
  static final int LAGS = 4;

  /** A stretch that tells the lateness less well says nothing. */
  private static final double VAGUE_S = 0.1;

  private static final int FEWEST = 20;

  /** What is farther out than so many deviations counts no more than that. */
  private static final double FAR = 2;

  private static final int ALONG = 0;
  private static final int TURN = 2;

  private final MotionSteps given;
  private final double[][] residuals;
  private final double[][] perS;
  private final List<Stretch> stretches = new ArrayList<>();
  private final boolean enough;
  private final double middleS;
  private final double spreadS;

  private record Stretch(int run, double startS, double lateS, double errorS) {
    boolean isKnown() {
      return errorS < VAGUE_S;
    }
  }

  /**
   * Measures.
   *
   * @param given steps
   * @param residuals what an explanation leaves over, by component and step
   * @param perS how the expected steps change for a second by which commands act later
   */
  Lateness(MotionSteps given, double[][] residuals, double[][] perS) {
    this.given = given;
    this.residuals = residuals;
    this.perS = perS;
    double[] scales = {scale(ALONG), 1, scale(TURN)};
    for (int i = 0; i < given.size(); ) {
      MotionSteps.Step first = given.step(i);
      double pull = 0;
      double information = 0;
      for (; i < given.size() && belongs(first, given.step(i)); i++) {
        for (int c : new int[] {ALONG, TURN}) {
          pull += residuals[c][i] * perS[c][i] / (scales[c] * scales[c]);
          information += perS[c][i] * perS[c][i] / (scales[c] * scales[c]);
        }
      }
      double late = information > 0 ? pull / information : 0;
      stretches.add(
          new Stretch(first.run(), first.from().timeS(), late, 1 / Math.sqrt(information)));
    }
    double[] known =
        stretches.stream().filter(Stretch::isKnown).mapToDouble(Stretch::lateS).sorted().toArray();
    enough = known.length >= FEWEST;
    middleS = enough ? known[known.length / 2] : 0;
    spreadS =
        enough
            ? (known[known.length * 3 / 4] - known[known.length / 4]) / (2 * NormalChance.MEDIAN)
            : 0;
  }

  private double scale(int component) {
    double[] sizes = Arrays.stream(residuals[component]).map(Math::abs).sorted().toArray();
    double median = sizes.length == 0 ? 0 : sizes[sizes.length / 2];
    return Math.max(1e-9, median / NormalChance.MEDIAN);
  }

  private static boolean belongs(MotionSteps.Step first, MotionSteps.Step step) {
    return step.run() == first.run() && step.from().timeS() < first.from().timeS() + STRETCH_S;
  }

  /**
   * Returns a sum of {@link #LAGS} squares that is chi-square where how late one stretch is says
   * nothing about the next ones; 0 where too few stretches are known.
   */
  double hangsTogether() {
    if (!enough) {
      return 0;
    }
    double square = 0;
    for (int lag = 1; lag <= LAGS; lag++) {
      double sum = 0;
      double variance = 1e-12;
      for (int k = lag; k < stretches.size(); k++) {
        double product = deviation(stretches.get(k)) * deviation(stretches.get(k - lag));
        if (areSoFarApart(stretches.get(k), stretches.get(k - lag), lag)) {
          sum += product;
          variance += product * product;
        }
      }
      square += sum * sum / variance;
    }
    return square;
  }

  private double deviation(Stretch one) {
    double deviation = (one.lateS - middleS) / Math.max(1e-9, spreadS);
    return Math.max(-FAR, Math.min(FAR, deviation));
  }

  private static boolean areSoFarApart(Stretch one, Stretch before, int lag) {
    return one.run == before.run
        && one.isKnown()
        && before.isKnown()
        && one.startS - before.startS < (lag + 1) * STRETCH_S;
  }

  /** Returns what lateness that changes by its spread adds to what was seen, by component. */
  double[][] part() {
    double[][] part = new double[perS.length][given.size()];
    for (int c : new int[] {ALONG, TURN}) {
      Arrays.setAll(part[c], i -> spreadS * perS[c][i]);
    }
    return part;
  }
}
