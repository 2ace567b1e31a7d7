package simbad.motion.forecast;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.Way;
import simbad.sonar.check.Checks;

/**
 * A model of motion with how far it may be off.
 *
 * @param chain how the robot moves and what the tracker reports
 * @param spreads by horizon, in the order of {@link Windows#horizonsS}
 */
public record MotionForecast(MotionChain chain, List<Spread> spreads) {
  /** Standard normal deviates of the levels 0.50 to 0.95; the others are their mirror images. */
  private static final double[] DEVIATES = {
    0, 0.1256613, 0.2533471, 0.3853205, 0.5244005, 0.6744898, 0.8416212, 1.0364334, 1.2815516,
    1.6448536
  };

  /** Copies the list. */
  public MotionForecast {
    spreads = List.copyOf(spreads);
  }

  /**
   * A window's forecast.
   *
   * @param run name of the run
   * @param startS when the window begins
   * @param horizonS how long it is
   * @param quantiles by component (along m, across m, turn rad), each q05 to q95
   */
  @SuppressWarnings("ArrayRecordComponent") // Numbers, never compared.
  public record Row(String run, double startS, double horizonS, double[][] quantiles) {
    /** Checks the times and that all quantiles are numbers. */
    public Row {
      Checks.finite("startS", startS);
      Checks.positive("horizonS", horizonS);
      Checks.numbers("quantiles", quantiles);
    }

    private static final Comparator<Row> ORDER =
        Comparator.comparingDouble(Row::startS).thenComparingDouble(Row::horizonS);
  }

  /** Returns what is believed: exact motion, and a tracker that is off at both ends of a window. */
  public static MotionForecast believed(Robot robot) {
    Spread spread =
        Spread.one(
            new double[][] {
              normal(robot.trackSigmaM()),
              normal(robot.trackSigmaM()),
              normal(robot.trackSigmaRad())
            });
    return new MotionForecast(robot.motion(), List.of(spread, spread, spread));
  }

  private static double[] normal(double sigma) {
    double[] quantiles = new double[PinballLoss.QUANTILES];
    for (int q = 0; q < quantiles.length; q++) {
      int off = q - PinballLoss.QUANTILES / 2;
      quantiles[q] = Math.signum(off) * DEVIATES[Math.abs(off)] * sigma * Math.sqrt(2);
    }
    return quantiles;
  }

  /** Returns the forecasts of all windows of some runs: by run, start and horizon. */
  public List<Row> of(List<MotionRun> runs) {
    List<Row> rows = new ArrayList<>();
    for (MotionRun run : runs) {
      rows.addAll(of(run));
    }
    return rows;
  }

  private List<Row> of(MotionRun run) {
    double[] horizons = Windows.horizonsS();
    List<Row> rows = new ArrayList<>();
    Exertion exertion = Exertion.of(run);
    Way way = Way.of(run, chain);
    for (int h = 0; h < horizons.length; h++) {
      for (Window window : Windows.of(List.of(run), horizons[h])) {
        double asked = exertion.between(window.startS(), window.endS());
        Displacement expected = way.between(window.startS(), window.endS());
        rows.add(row(run.name(), window, expected, asked));
      }
    }
    rows.sort(Row.ORDER);
    return rows;
  }

  private Row row(String run, Window window, Displacement expected, double asked) {
    int horizon = Arrays.binarySearch(Windows.horizonsS(), window.horizonS());
    double[][] quantiles = new double[3][];
    for (int c = 0; c < quantiles.length; c++) {
      double middle = expected.component(c);
      double[] off = spreads.get(horizon).at(asked, c);
      quantiles[c] = Arrays.stream(off).map(by -> middle + by).toArray();
    }
    return new Row(run, window.startS(), window.horizonS(), quantiles);
  }
}
