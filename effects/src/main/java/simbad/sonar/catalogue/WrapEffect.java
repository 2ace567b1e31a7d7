package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.Wrap;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Readings start again from 0 beyond some value. */
public final class WrapEffect implements Definition {
  private static final int MODES = 4;

  @Override
  public Effect effect() {
    return Effect.WRAP;
  }

  @Override
  public String happens() {
    return "readings start again from 0 beyond some value";
  }

  @Override
  public String cause() {
    return "a counter or a message that is too narrow for far ranges";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "modulus",
            v -> new Wrap(v[0]),
            Parameter.of(
                "modulus_m",
                Double.POSITIVE_INFINITY,
                0.1,
                setup.sensor().maxRangeM(),
                0.256,
                1.28,
                2.55,
                2.56)));
  }

  /** What readings that are too near are too near by. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    List<Double> moduli = new ArrayList<>(form.parameters().get(0).tries());
    moduli.addAll(
        Modes.of(
            clues
                .echoesInCone()
                .filter(i -> clues.log().rangeM(i) < clues.nearestM(i) - 0.05)
                .mapToDouble(i -> clues.nearestM(i) - clues.log().rangeM(i)),
            0.01,
            MODES));
    return Tries.product(form, moduli);
  }

  /** A quarter of what the sensor reaches. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(
            Forms.find(effect(), "modulus", setup, log.sensors()).orElseThrow(),
            0,
            0.75 * setup.sensor().maxRangeM()));
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "use a number with more bits: readings start again from 0 after %.3f m",
        values.value("modulus_m"));
  }
}
