package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
}
