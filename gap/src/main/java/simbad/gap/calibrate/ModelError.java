package simbad.gap.calibrate;

import java.util.Arrays;
import java.util.List;
import simbad.gap.calibrate.level.LevelCalibrator;
import simbad.gap.diagnosis.SetupError;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapMeter;
import simbad.gap.unexplained.Clumping;
import simbad.gap.unexplained.Misfit;
import simbad.gap.unexplained.SetupScores;
import simbad.gap.unexplained.Surprise;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/**
 * How far a calibrated set-up is off on rows of its reference that it was not fitted on. More rows
 * make the calibration better, but not this figure smaller than the model is wrong.
 *
 * @param rows of the reference that were held out, each once
 * @param gapM mean gap of these rows, metres
 * @param expectedM what it would be if the calibrated set-up were right, metres
 * @param echoes by how much more sums of echoes over blocks vary than those of independent pings
 *     would; at least 1
 * @param ranges the same of where ranges lie in their distributions
 * @param misfit mean of the greatest misfits, as {@link Misfit#top} has it
 * @param excessDb by how much levels are off from place to place, decibels
 * @param rangeM the same of ranges, metres
 */
public record ModelError(
    int rows,
    double gapM,
    double expectedM,
    double echoes,
    double ranges,
    double misfit,
    double excessDb,
    double rangeM) {
  /** Refuses what is no number. */
  public ModelError {
    Checks.number("gapM", gapM);
    Checks.number("expectedM", expectedM);
    Checks.number("echoes", echoes);
    Checks.number("ranges", ranges);
    Checks.number("misfit", misfit);
    Checks.number("excessDb", excessDb);
    Checks.number("rangeM", rangeM);
  }

  /** So many parts, each held out once. */
  static final int PARTS = 5;

  /**
   * Holds out a level law's reference part by part.
   *
   * @param setup as believed, under the level law
   * @param reference in more than one block
   */
  static ModelError ofLevel(SensingSetup setup, PingLog reference) {
    LevelCalibrator calibrator = new LevelCalibrator(setup, reference);
    Blocks blocks = new Blocks(reference);
    double[] gap = new double[reference.size()];
    double[] expected = new double[reference.size()];
    Surprise all = new Surprise(new CalibratedLog(setup, List.of(), reference), Hypothesis.NONE);
    PlaceError places = new PlaceError(setup.scene().obstacles().size());
    for (int part = 0; part < PARTS; part++) {
      Fold out = blocks.part(part, PARTS);
      Hypothesis fitted = calibrator.fit(ping -> !out.holds(ping)).setup();
      CalibratedLog given = new CalibratedLog(setup, fitted.changes(), reference);
      GapMeter.Gaps gaps = new GapMeter(given).measure(given, Hypothesis.NONE);
      Surprise surprise = new Surprise(given, Hypothesis.NONE);
      for (int ping = 0; ping < gap.length; ping++) {
        if (out.holds(ping)) {
          gap[ping] = gaps.observedM()[ping];
          expected[ping] = gaps.expectedM()[ping];
          all.take(surprise, ping);
        }
      }
      places.take(SetupScores.of(given, Hypothesis.NONE), out::holds);
    }
    double echoes = Clumping.ofEchoes(all);
    double ranges = Clumping.ofRanges(all);
    return new ModelError(
        gap.length,
        Arrays.stream(gap).average().orElse(0),
        Arrays.stream(expected).average().orElse(0),
        echoes,
        ranges,
        Misfit.of(all).top(Misfit.TOP, echoes, ranges),
        places.excessDb(),
        places.rangeM());
  }

  /**
   * Returns by how much more than by chance the set-up is off in slices of a log of so many rows:
   * what is wrong stays where it is, and more rows show it more surely.
   *
   * @param chance what misfits come to by chance
   * @param log rows of it
   * @return at least 1
   */
  double misfitTimes(double chance, int log) {
    return Math.max(1, misfit / chance * Math.sqrt((double) log / rows));
  }

  /** Returns by how much more the gap is than the set-up expects of itself, at least 1. */
  double gapTimes() {
    return expectedM > 0 ? Math.max(1, gapM / expectedM) : 1;
  }

  /** Returns the same as a diagnosis says it. */
  public SetupError finding() {
    return new SetupError(rows, 100 * gapM, 100 * expectedM, echoes, ranges, misfit);
  }
}
