package simbad.gap.unexplained;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.slice.Axis;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.ChangedModel;

/**
 * How many echoes a hypothesis with memory expects where no reading is known, and how far that
 * number may stray, by drawing whole logs. What a memory learns ping by ping can hide that what it
 * learnt has another cause: bursts, say, that always come at the same distance.
 */
final class Foresight {
  private static final int DRAWS = 80;

  private final double[] expected;
  private final boolean[][] drawn;

  private Foresight(double[] expected, boolean[][] drawn) {
    this.expected = expected;
    this.drawn = drawn;
  }

  /** Looks ahead through a log. */
  static Foresight of(CalibratedLog given, Hypothesis hypothesis) {
    ChangedModel model = given.model(hypothesis);
    Geometry geometry = given.geometry(model);
    List<ReadingDistribution> forecast = given.forecast(model);
    double[] expected =
        forecast.stream().mapToDouble(reading -> 1 - reading.noEchoProbability()).toArray();
    boolean[][] drawn =
        IntStream.range(0, DRAWS)
            .parallel()
            .mapToObj(draw -> echoes(model.draw(geometry, new Random(draw))))
            .toArray(boolean[][]::new);
    return new Foresight(expected, drawn);
  }

  private static boolean[] echoes(double[] rangeM) {
    boolean[] echo = new boolean[rangeM.length];
    for (int i = 0; i < echo.length; i++) {
      echo[i] = rangeM[i] < Double.POSITIVE_INFINITY;
    }
    return echo;
  }

  /**
   * Returns for each slice of a cut by how many echoes the log is off, and by how many logs are.
   */
  double[][] off(Axis cut, boolean[] echo) {
    double[] off = new double[cut.count()];
    double[][] other = new double[drawn.length][cut.count()];
    for (int i = 0; i < echo.length; i++) {
      int at = cut.bin(i);
      if (at >= 0) {
        off[at] += (echo[i] ? 1 : 0) - expected[i];
        for (int draw = 0; draw < drawn.length; draw++) {
          other[draw][at] += (drawn[draw][i] ? 1 : 0) - expected[i];
        }
      }
    }
    double[] deviation = new double[cut.count()];
    for (int at = 0; at < deviation.length; at++) {
      double squares = 0;
      for (double[] draw : other) {
        squares += draw[at] * draw[at];
      }
      deviation[at] = Math.sqrt(squares / drawn.length);
    }
    return new double[][] {off, deviation};
  }
}
