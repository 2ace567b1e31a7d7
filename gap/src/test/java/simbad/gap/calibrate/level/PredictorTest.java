package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.level.LevelLaw;

class PredictorTest {
  private static final LevelLaw LAW = LevelWorlds.POST.sensor().levelLaw();
  private static final List<Believed> TARGETS =
      LevelWorlds.POST.scene().obstacles().stream()
          .map(one -> new Believed(one, LevelWorlds.POST.sensor()))
          .toList();
  private static final Layout LAYOUT = new Layout(TARGETS);

  private static Predictor predictor() {
    Predictor predictor =
        new Predictor(LAYOUT, LAW, TARGETS, LevelForms.wavenumberPerM(LevelWorlds.POST));
    double[] values = new double[LAYOUT.size()];
    values[0] = LevelWorlds.SPREADING;
    values[1] = LevelWorlds.ABSORPTION;
    values[LAYOUT.aperture()] = Math.log(LevelWorlds.APERTURE_M);
    // A square post: lobes at its faces, four times round.
    for (int orbit = 0; orbit < TARGETS.get(0).orbits(); orbit++) {
      values[LAYOUT.lobe(0, orbit)] = 3 * Math.cos(orbit);
    }
    predictor.set(values);
    return predictor;
  }

  private static Trials.Trial trial(double bearingRad) {
    return new Trials.Trial(0, 0, bearingRad, 1.2, 1.1, 0.05, true, 0, 1, 0);
  }

  /** Against differences of the excess, which is straight between two bearings. */
  @Test
  void anExcessRisesWithTheBearingAsItsDifferencesSay() {
    Predictor predictor = predictor();
    double steepest = 0;
    for (double bearing = 0.01; bearing < 6.2; bearing += 0.0873) {
      double step = 1e-4;
      double above = predictor.excess(predictor.row(trial(bearing + step))).decibels();
      double below = predictor.excess(predictor.row(trial(bearing - step))).decibels();
      double rise = (above - below) / (2 * step);

      assertEquals(rise, predictor.perTurnDb(predictor.row(trial(bearing))), 1e-6);
      steepest = Math.max(steepest, Math.abs(rise));
    }
    assertTrue(steepest > 10, "no lobe has a flank");
  }

  /** Against differences, one value after the other; the last is in units of the scatter. */
  @Test
  void slopesAreDifferencesOfTheExcess() {
    Predictor predictor = predictor();
    double[] values = new double[LAYOUT.size()];
    Arrays.setAll(values, i -> 0.1 * Math.sin(i));
    values[0] = LevelWorlds.SPREADING;
    values[1] = LevelWorlds.ABSORPTION;
    values[LAYOUT.aperture()] = Math.log(LevelWorlds.APERTURE_M);
    values[LAYOUT.squint()] = 0.02;
    Trials.Trial trial = new Trials.Trial(0, 0, 0.3, 0.75, 0.7, 0.2, true, 1.5, 1, 0);
    double[] slopes = slopes(predictor, trial, values);
    for (int i = 0; i < values.length; i++) {
      double rise =
          (excess(predictor, trial, values, i, 1e-5, true)
                  - excess(predictor, trial, values, i, -1e-5, true))
              / 2e-5;
      if (i != LAYOUT.scatter()) {
        // The beam's own slope is taken over a hundredth of its radius, a tenth of a degree.
        assertEquals(rise, slopes[i], 1e-6 + 2e-3 * Math.abs(rise), "value " + i);
      }
    }
    int last = LAYOUT.scatter();
    double rise =
        (excess(predictor, trial, values, last, 1e-5, false)
                - excess(predictor, trial, values, last, -1e-5, false))
            / 2e-5;
    predictor.set(values);
    double deviation = predictor.excess(predictor.row(trial)).deviationDb();
    assertEquals(rise * deviation, slopes[last], 1e-6);
  }

  private static double[] slopes(Predictor predictor, Trials.Trial trial, double[] values) {
    predictor.set(values);
    Predictor.Row row = predictor.row(trial);
    Predictor.Slope slope = new Predictor.Slope();
    predictor.slope(row, predictor.excess(row), slope);
    double[] all = new double[values.length];
    for (int i = 0; i < slope.size(); i++) {
      all[slope.index(i)] += slope.value(i);
    }
    return all;
  }

  private static double excess(
      Predictor predictor, Trials.Trial trial, double[] values, int at, double by, boolean plain) {
    double[] moved = values.clone();
    moved[at] += by;
    predictor.set(moved);
    Predictor.Excess excess = predictor.excess(predictor.row(trial));
    return plain ? excess.decibels() : excess.inDeviations();
  }

  /** What is added to a trial is added to its excess; so is what all targets have in common. */
  @Test
  void whatIsAddedIsAdded() {
    Predictor predictor = predictor();
    double plain = predictor.excess(predictor.row(trial(1))).decibels();

    double added = predictor.excess(predictor.row(trial(1).plus(2.5, 1, 0))).decibels();

    assertEquals(2.5, added - plain, 1e-9);
  }
}
