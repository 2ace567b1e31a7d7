package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.Gain;
import simbad.sonar.change.LevelGain;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

/** All thresholds shrink or grow in proportion. */
public final class GainEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.GAIN;
  }

  @Override
  public String happens() {
    return "all thresholds shrink or grow in proportion";
  }

  @Override
  public String briefly() {
    return "every echo is weaker or stronger";
  }

  @Override
  public String cause() {
    return "a low supply voltage, dirt on the transducer or its ageing, another amplification";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "factor",
            v -> new Gain(v[0]),
            Parameter.of("factor", 1, 0.2, 3, 0.7, 0.85, 0.95, 1.05, 1.15, 1.3)));
  }

  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "level",
            v -> new LevelGain(v[0]),
            Parameter.of("gain_db", 0, -40, 40, -10, -5, -2, 2, 5, 10)));
  }

  /** 3 %, as well as thresholds repeat on a bench; half a decibel. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    boolean level = setup.sensor().law().isLevel();
    List<Form> forms = Forms.of(this, setup, log.sensors());
    return List.of(Probe.alone(forms.get(0), 0, level ? 0.5 : 0.03));
  }

  /** 0.15 dB is what a supply and the air change from one day to the next. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return Math.abs(values[0] - form.neutral()[0]) < 0.3;
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    return form.with(values) instanceof Gain gain
        ? Optional.of(
            stated.with(
                Scenes.detected(
                    stated.scene(), Optional.empty(), heard -> scaled(heard, gain.factor()))))
        : Optional.empty();
  }

  /** Strengths stay: under the level law a gain is one in decibels. */
  private static Detection scaled(Detection heard, double factor) {
    if (heard instanceof UniformDetection uniform) {
      return new UniformDetection(scaled(uniform.rangeM(), factor));
    }
    return heard instanceof TableDetection table
        ? new TableDetection(
            ThresholdTable.of(
                Arrays.stream(table.table().valuesM()).map(v -> scaled(v, factor)).toArray()))
        : heard;
  }

  private static double scaled(double thresholdM, double factor) {
    return Math.min(ThresholdTable.GREATEST_THRESHOLD_M, factor * thresholdM);
  }

  @Override
  public String remedy(FittedValues values) {
    return values.has("gain_db")
        ? text(
            "restore the sensor's drive voltage, or calibrate again: echoes are %.1f dB "
                + "too %s",
            Math.abs(values.value("gain_db")), values.value("gain_db") < 0 ? "weak" : "strong")
        : text(
            "multiply all thresholds by %.2f, or restore the sensor's drive voltage",
            values.value("factor"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.BESIDE_THE_LAW);
  }
}
