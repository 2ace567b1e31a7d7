package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import simbad.figures.diagnosis.RowFinding.Fit;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.ForecastGap;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** All rows of a data set before and after, for the figures; in the order of the log. */
public final class RowSurvey {
  private static final double CM = 100;

  /** Half of the finest step that recordings are rounded to. */
  private static final double HALF_STEP_M = 5e-4;

  /** Below it, what an echo would have been says nothing about the one that came. */
  private static final double EXPECTED = 0.05;

  private static final double[] MEDIAN = {0.5};

  /** Of echoes, without the outer tenths: strays are expected there. */
  private static final double[] MIDDLE = {
    0.12, 0.16, 0.2, 0.24, 0.28, 0.32, 0.36, 0.4, 0.44, 0.48, 0.52, 0.56, 0.6, 0.64, 0.68, 0.72,
    0.76, 0.8, 0.84, 0.88
  };

  private RowSurvey() {}

  /**
   * Computes the findings.
   *
   * @param data the rows
   * @param changes of the diagnosed model
   * @param random breaks ties between readings of one probability
   */
  public static List<RowFinding> of(
      DataSet data, List<? extends Change> changes, RandomGenerator random) {
    PingLog log = new PingLog(data.readings());
    ChangedModel nominal = new ChangedModel(data.setup(), List.of());
    ChangedModel diagnosed = new ChangedModel(data.setup(), changes);
    Geometry believed = nominal.geometry(log);
    List<ReadingDistribution> before = nominal.forecast(believed);
    List<ReadingDistribution> after = diagnosed.forecast(diagnosed.geometry(log));
    double noEchoM = data.setup().noEchoM();
    List<RowFinding> findings = new ArrayList<>(log.size());
    for (int ping = 0; ping < log.size(); ping++) {
      ReadingRow row = data.readings().get(log.row(ping));
      double tie = random.nextDouble();
      findings.add(
          finding(
              believed,
              ping,
              fit(before.get(ping), row.reading(), noEchoM, tie),
              fit(after.get(ping), row.reading(), noEchoM, tie)));
    }
    return findings;
  }

  private static RowFinding finding(Geometry geometry, int ping, Fit before, Fit after) {
    PingLog log = geometry.log();
    int nearest = nearest(geometry, ping);
    boolean any = geometry.obstacles() > 0;
    int line = ping * geometry.obstacles() + nearest;
    return new RowFinding(
        nearest,
        any ? bearingDeg(geometry, ping, nearest) : 0,
        any ? OptionalDouble.of(geometry.centreDistanceM(line)) : OptionalDouble.empty(),
        any
            ? OptionalDouble.of(Math.abs(Math.toDegrees(geometry.offAxisRad(line))))
            : OptionalDouble.empty(),
        log.timeS(ping) - log.runStartS(ping),
        log.speedMPerS(ping),
        before,
        after);
  }

  /** Not the line of sight's own, which knows the bearing of what is in the cone only. */
  private static double bearingDeg(Geometry geometry, int ping, int obstacle) {
    return Math.toDegrees(
        geometry
            .scene()
            .obstacles()
            .get(obstacle)
            .worldFromObstacle()
            .bearingRad(geometry.xM(ping), geometry.zM(ping)));
  }

  private static int nearest(Geometry geometry, int ping) {
    int first = ping * geometry.obstacles();
    int nearest = 0;
    for (int o = 1; o < geometry.obstacles(); o++) {
      if (geometry.centreDistanceM(first + o) < geometry.centreDistanceM(first + nearest)) {
        nearest = o;
      }
    }
    return nearest;
  }

  private static Fit fit(
      ReadingDistribution forecast, Reading reading, double noEchoM, double tie) {
    double[] quantiles = ForecastGap.quantilesM(forecast, noEchoM);
    return new Fit(
        CM * ForecastGap.gapM(quantiles, reading, noEchoM),
        pit(forecast, reading, tie),
        residual(forecast, reading, MEDIAN),
        residual(forecast, reading, MIDDLE));
  }

  /** No-echo ranks behind every echo; a tie is broken by chance (Smith 1985). */
  private static double pit(ReadingDistribution forecast, Reading reading, double tie) {
    double echo = 1 - forecast.noEchoProbability();
    if (!(reading instanceof Echo heard)) {
      return echo + tie * (1 - echo);
    }
    // Of one outcome: a step of the resolution, or what recordings round to where there is none.
    double below = forecast.echoUpTo(heard.rangeM() - HALF_STEP_M);
    double upTo = forecast.echoUpTo(heard.rangeM() + HALF_STEP_M);
    return below + tie * (upTo - below);
  }

  /** The reading less the mean of the expected echoes at some levels. */
  private static OptionalDouble residual(
      ReadingDistribution forecast, Reading reading, double... levels) {
    double echo = 1 - forecast.noEchoProbability();
    if (!(reading instanceof Echo heard) || echo < EXPECTED) {
      return OptionalDouble.empty();
    }
    double sum = 0;
    for (double level : levels) {
      sum += forecast.quantileM(level * echo, Double.POSITIVE_INFINITY);
    }
    return OptionalDouble.of(CM * (heard.rangeM() - sum / levels.length));
  }

  /** Returns the share of a sorted array's values at or below which a value lies. */
  static double quantile(double[] values, double level) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted.length == 0
        ? 0
        : sorted[(int) Math.min(sorted.length - 1, level * sorted.length)];
  }
}
