package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.Burst;
import simbad.sonar.change.Dropout;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** Echoes are missed, singly or in bursts, whatever the geometry. */
public final class DropoutEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.DROPOUT;
  }

  @Override
  public String happens() {
    return "echoes are missed at random, wherever the obstacle is";
  }

  @Override
  public String cause() {
    return "electrical noise, a loose contact, wind, a surface that scatters the sound";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "single",
            v -> new Dropout(v[0]),
            Parameter.of("share", 0, 0, 1, 0.05, 0.2, 0.5).asClosed()),
        Form.of(
            effect(),
            "bursts",
            v -> new Burst(v[0], v[1], 1),
            Parameter.of("share", 0, 0, 0.9, 0.1, 0.3),
            Parameter.of("length_pings", 1, 1, Burst.LONGEST_PINGS, 3, 8)));
  }

  /** A twentieth of the echoes. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "single", setup, log.sensors()).orElseThrow(), 0, 0.05));
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    SonarSpec sensor = stated.sensor();
    return form.with(values) instanceof Dropout missed
        ? Optional.of(
            stated.with(
                sensor.withScatter(
                    sensor.rangeNoiseM(),
                    1 - (1 - sensor.missRate()) * (1 - missed.share()),
                    sensor.edgeWidthM())))
        : Optional.empty();
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "set the sensor's miss_rate to %.2g, or ping again when nothing is heard",
        values.value("share"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP);
  }
}
