package simbad.gap.calibrate.level;

import java.util.List;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.scene.SonarSpec;

/** Posts that are heard up to 1.5 m from their centres: the excess there is 0 dB. */
final class LevelPosts {
  private LevelPosts() {}

  static Predictor predictor(List<Believed> targets) {
    SonarSpec sensor = LevelWorlds.POST.sensor();
    Layout layout = new Layout(targets);
    Predictor predictor =
        new Predictor(layout, sensor.levelLaw(), targets, LevelForms.wavenumberPerM(sensor));
    double[] values = new double[layout.size()];
    values[0] = 1.5;
    values[1] = 1;
    values[layout.aperture()] = Math.log(LevelForms.APERTURE_M);
    predictor.set(values);
    return predictor;
  }
}
