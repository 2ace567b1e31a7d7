package simbad.gap.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.scene.SensingSetup;

/**
 * The scene as it should have been stated: with what was named and what a scene can say.
 *
 * @param setup the scene
 * @param corrected effects that are in it now
 * @param elsewhere effects that no field of a scene says: of the robot, of its program, of time
 */
public record CorrectedScene(SensingSetup setup, List<Effect> corrected, List<Effect> elsewhere) {
  /** Copies the lists. */
  public CorrectedScene {
    corrected = List.copyOf(corrected);
    elsewhere = List.copyOf(elsewhere);
  }

  /**
   * Corrects a scene by a diagnosis.
   *
   * @param stated the scene as it was stated
   * @param diagnosis of data before it
   * @return the scene as it was stated where the verdict names nothing
   */
  public static CorrectedScene of(SensingSetup stated, Diagnosis diagnosis) {
    List<Effect> corrected = new ArrayList<>();
    List<Effect> elsewhere = new ArrayList<>();
    SensingSetup setup = stated;
    if (diagnosis.verdict().namesEffects()) {
      Hypothesis named = diagnosis.fitted();
      for (int i = 0; i < named.forms().size(); i++) {
        Form form = named.forms().get(i);
        Optional<SensingSetup> more =
            Definitions.of(form.effect()).corrected(setup, form, named.valuesOf(i));
        (more.isPresent() ? corrected : elsewhere).add(form.effect());
        setup = more.orElse(setup);
      }
    }
    return new CorrectedScene(setup, corrected, elsewhere);
  }
}
