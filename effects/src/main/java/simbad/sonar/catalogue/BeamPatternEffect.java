package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.BeamPattern;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Off the axis the threshold is shorter. */
public final class BeamPatternEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.BEAM_PATTERN;
  }

  @Override
  public String happens() {
    return "thresholds are shorter off the axis";
  }

  @Override
  public String briefly() {
    return "sensitivity tapers off the axis";
  }

  @Override
  public String cause() {
    return "the directivity of the transducer, which a cone with sharp edges leaves out";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double half = Math.toDegrees(setup.sensor().coneHalfAngleRad());
    List<Form> forms = new ArrayList<>();
    for (BeamPattern.Law law : BeamPattern.Law.values()) {
      String name = law.name().toLowerCase(Locale.ROOT);
      forms.add(pattern(name, law, BeamPattern.Angle.CENTRE, half));
      forms.add(pattern(name + "-outline", law, BeamPattern.Angle.OUTLINE, half));
      forms.add(pattern(name + "-nearest", law, BeamPattern.Angle.NEAREST, half));
    }
    return forms;
  }

  private Form pattern(String name, BeamPattern.Law law, BeamPattern.Angle angle, double halfDeg) {
    double least = law == BeamPattern.Law.BELL ? 0.2 * halfDeg : 0.5 * halfDeg;
    return Form.of(
        effect(),
        name,
        v -> new BeamPattern(toRadians(v[0]), v[1], law, angle),
        Parameter.of(
            "width_deg",
            Double.POSITIVE_INFINITY,
            least,
            20 * halfDeg,
            0.7 * halfDeg,
            1.1 * halfDeg,
            2 * halfDeg),
        Parameter.of("power", 1, 0.3, 8, 0.7, 2).asClosed());
  }

  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return List.of(BeamWidthEffect.aperture(effect()));
  }

  /** A taper that takes 6 % at the cone's edge; a tenth of a beam. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    boolean level = setup.sensor().law().isLevel();
    List<Form> forms = Forms.of(this, setup, log.sensors());
    return List.of(
        Probe.alone(
            forms.get(0), 0, level ? 0.1 : 4 * Math.toDegrees(setup.sensor().coneHalfAngleRad())));
  }

  @Override
  public String remedy(FittedValues values) {
    return BeamWidthEffect.ofAperture(values)
        .orElseGet(
            () ->
                text(
                    "give the sensor a beam pattern: off the axis thresholds are shorter, with a width of"
                        + " %.1f degrees",
                    values.value("width_deg")));
  }
}
