package simbad.blindworld.baseline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.MotionLog;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Windows;

/**
 * The rule that a serious diagnosis of motion has to beat: when the windows are beyond what the
 * nominal robot before its tracker itself shows, the line that fits the residuals of two seconds
 * best names one effect.
 */
final class MotionRule {

  private static final int REPEATS = 40;
  private static final int NULLS = 10;
  private static final double LIMIT = 4;
  private static final long SEED = 5;
  private static final int TWO_SECONDS = 1;
  private static final int ALONG = 0;
  private static final int TURN = 2;

  /** What has to be left out of the residuals' squares by a line for it to name an effect. */
  private static final double FITS = 0.3;

  private final Robot robot;

  MotionRule(Path set) throws IOException, FormatException {
    robot = MotionLog.robot(set.resolve("robot.json"));
  }

  private MotionLog log(Path folder) throws IOException, FormatException {
    return MotionLog.read(folder.resolve("commands.csv"), folder.resolve("track.csv"), robot);
  }

  private MotionForecast nominal(Outing outing) {
    return MotionForecast.of(MotionWorld.nominal(robot), outing, REPEATS, SEED);
  }

  /** The nominal forecast of a folder's windows. */
  String predictions(Path folder) throws IOException, FormatException {
    Outing outing = log(folder).outing();
    return nominal(outing).csv(Windows.of(outing));
  }

  /** The name of an effect, or nothing when the gap is within chance. */
  Optional<String> name(Path folder) throws IOException, FormatException {
    MotionLog log = log(folder);
    Windows windows = Windows.of(log.outing());
    MotionForecast forecast = nominal(log.outing());
    double[][] shown = windows.displacements(log.track());
    double[] units = forecast.losses(windows, shown);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < NULLS; i++) {
      double[][] chance =
          windows.displacements(MotionWorld.nominal(robot).drive(log.outing(), SEED + 1 + i));
      double gap = MotionForecast.gap(forecast.losses(windows, chance), units);
      sum += gap;
      squares += gap * gap;
    }
    double mean = sum / NULLS;
    double sd = Math.sqrt(Math.max(0, squares / NULLS - mean * mean));
    boolean beyond = 1 > mean + LIMIT * sd + 0.02;
    return beyond ? Optional.of(largest(windows, forecast, shown)) : Optional.empty();
  }

  private static String largest(Windows windows, MotionForecast forecast, double[][] shown) {
    Line along = new Line();
    Line turn = new Line();
    for (int i = 0; i < windows.size(); i++) {
      if (windows.at(i).horizon() == TWO_SECONDS) {
        double way = forecast.of(i, ALONG)[MotionForecast.LEVELS / 2];
        double angle = forecast.of(i, TURN)[MotionForecast.LEVELS / 2];
        along.add(way, shown[i][ALONG] - way);
        turn.add(angle, shown[i][TURN] - angle);
      }
    }
    if (turn.byShift() > FITS && turn.byShift() > Math.max(turn.byFactor(), along.byFactor())) {
      return "turn-bias";
    }
    if (Math.max(turn.byFactor(), along.byFactor()) < FITS) {
      return "motion-noise";
    }
    return turn.byFactor() > along.byFactor() ? "turn-scale" : "speed-scale";
  }

  /** Residuals against what was expected, as sums. */
  private static final class Line {
    private int n;
    private double sumEe;
    private double sumR;
    private double sumEr;
    private double sumRr;

    void add(double expected, double residual) {
      n++;
      sumEe += expected * expected;
      sumR += residual;
      sumEr += expected * residual;
      sumRr += residual * residual;
    }

    /** The share of the squares that one shift takes away. */
    double byShift() {
      return n == 0 || sumRr == 0 ? 0 : sumR * sumR / n / sumRr;
    }

    /** The share of the squares that one factor takes away. */
    double byFactor() {
      return sumEe == 0 || sumRr == 0 ? 0 : sumEr * sumEr / sumEe / sumRr;
    }
  }
}
