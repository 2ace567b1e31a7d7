package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.BeamWidth;
import simbad.sonar.change.LevelAperture;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** The cone is wider or narrower than believed. */
public final class BeamWidthEffect implements Definition {
  private static final String APERTURE = "aperture";
  private static final String FACTOR = "aperture_factor";

  @Override
  public Effect effect() {
    return Effect.BEAM_WIDTH;
  }

  @Override
  public String happens() {
    return "the cone is wider or narrower than believed";
  }

  @Override
  public String cause() {
    return "a transducer that differs from the data sheet, a housing or a tube in front of it";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double half = Math.toDegrees(setup.sensor().coneHalfAngleRad());
    return List.of(
        Form.of(
            effect(),
            "cone",
            v -> new BeamWidth(toRadians(v[0])),
            Parameter.of(
                "added_deg",
                0,
                -0.9 * half,
                Math.min(60, 180 - half),
                -0.4 * half,
                -0.2 * half,
                -1.5,
                1.5,
                0.2 * half,
                0.4 * half)));
  }

  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return List.of(aperture(effect()));
  }

  /**
   * Another size of the piston: under the level law both a beam's width and its pattern follow from
   * it, so that no log tells the two apart.
   */
  static Form aperture(Effect effect) {
    return Form.of(
        effect,
        APERTURE,
        v -> new LevelAperture(v[0]),
        Parameter.of(FACTOR, 1, 0.3, 3, 0.6, 0.75, 0.9, 1.1, 1.3, 1.7));
  }

  /** What to do about it; empty where something else was fitted. */
  static Optional<String> ofAperture(FittedValues values) {
    return values.has(FACTOR)
        ? Optional.of(
            text("make sensor.level.aperture_radius_m %.2f times as large", values.value(FACTOR)))
        : Optional.empty();
  }

  @Override
  public Optional<double[]> whereHeard(Form form, Clues.HeardArc arc) {
    return form.name().equals(APERTURE)
        ? Optional.empty()
        : Optional.of(new double[] {Math.toDegrees(arc.widerRad())});
  }

  /** A cone that is a degree off; a tenth of a beam. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    boolean level = setup.sensor().law().isLevel();
    List<Form> forms = Forms.of(this, setup, log.sensors());
    return List.of(Probe.alone(forms.get(0), 0, level ? 0.1 : 1));
  }

  @Override
  public String remedy(FittedValues values) {
    return ofAperture(values)
        .orElseGet(
            () ->
                text(
                    "set cone_half_angle_deg to %.1f",
                    Math.toDegrees(values.sensor().coneHalfAngleRad())
                        + values.value("added_deg")));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.BESIDE_THE_LAW);
  }
}
