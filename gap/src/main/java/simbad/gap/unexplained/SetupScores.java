package simbad.gap.unexplained;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import simbad.gap.calibrate.level.EchoCurves;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.change.LevelGain;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.ChangedModel;

/**
 * By how much each reading of a log would be likelier if echoes were stronger, or read longer, by a
 * little: what a set-up that is off shows itself by.
 */
@SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
public record SetupScores(Geometry geometry, double[] perDecibel, double[] perMetre) {
  /** Refuses what is no number. */
  public SetupScores {
    Checks.numbers("perDecibel", perDecibel);
    Checks.numbers("perMetre", perMetre);
  }

  private static final double STEP_DB = 0.25;
  private static final double STEP_M = 0.001;

  /**
   * Asks a hypothesis under the level law.
   *
   * @param given the log
   * @param hypothesis of it
   */
  public static SetupScores of(CalibratedLog given, Hypothesis hypothesis) {
    ChangedModel model = given.model(hypothesis);
    return new SetupScores(
        given.geometry(model),
        perDecibel(hypothesis, given::logLikelihood),
        perMetre(hypothesis, given::logLikelihood));
  }

  /** Returns by how much a value of each ping rises with the excess of what it hears. */
  public static double[] perDecibel(
      Hypothesis hypothesis, Function<List<Change>, double[]> values) {
    return slopes(hypothesis, values, LevelGain::new, STEP_DB).slope();
  }

  /** Returns how likely each ping is where the excess of what it hears is another. */
  public static EchoCurves echoes(Hypothesis hypothesis, Function<List<Change>, double[]> values) {
    return new EchoCurves(decibels -> values.apply(and(hypothesis, new LevelGain(decibels))));
  }

  /** Returns by how much a value of each ping rises with its range, metres. */
  public static double[] perMetre(Hypothesis hypothesis, Function<List<Change>, double[]> values) {
    return metres(hypothesis, values).slope();
  }

  /**
   * How a value of each ping rises with something.
   *
   * @param slope of it
   * @param most the greater of the values a step to either side
   */
  public record Slopes(double[] slope, double[] most) {
    /** Refuses what is no number. */
    public Slopes {
      Checks.numbers("slope", slope);
      Checks.numbers("most", most);
    }
  }

  /** Returns how a value of each ping rises with its range, by the metre. */
  public static Slopes metres(Hypothesis hypothesis, Function<List<Change>, double[]> values) {
    return slopes(hypothesis, values, RangeOffset::new, STEP_M);
  }

  private static Slopes slopes(
      Hypothesis hypothesis,
      Function<List<Change>, double[]> values,
      DoubleFunction<Change> change,
      double step) {
    double[] up = values.apply(and(hypothesis, change.apply(step)));
    double[] down = values.apply(and(hypothesis, change.apply(-step)));
    double[] slope = new double[up.length];
    Arrays.setAll(slope, i -> (up[i] - down[i]) / (2 * step));
    double[] most = new double[up.length];
    Arrays.setAll(most, i -> Math.max(up[i], down[i]));
    return new Slopes(slope, most);
  }

  private static List<Change> and(Hypothesis hypothesis, Change change) {
    List<Change> changes = new ArrayList<>(hypothesis.changes());
    changes.add(change);
    return changes;
  }
}
