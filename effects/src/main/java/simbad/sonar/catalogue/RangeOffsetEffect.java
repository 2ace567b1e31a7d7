package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.GatedOffset;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.change.ScatteredOffset;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** Every range is too long or too short by the same amount. */
public final class RangeOffsetEffect implements Definition {
  private static final Parameter OFFSET =
      Parameter.of("offset_m", 0, -1, 1, -0.1, -0.03, 0.03, 0.1);

  /** What scatters by more than so much of an offset is noise beside it. */
  private static final double MOST_SCATTER = 0.15;

  private static final double LEAST_SOFT_M = 0.002;

  private static final double MODE_M = 0.02;
  private static final int MODES = 2;

  @Override
  public Effect effect() {
    return Effect.RANGE_OFFSET;
  }

  @Override
  public String happens() {
    return "every range is too long or too short by the same amount";
  }

  @Override
  public String cause() {
    return "a fixed delay in the electronics or the program, or a distance that was measured from the wrong point";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(effect(), "constant", v -> new RangeOffset(v[0]), OFFSET),
        Form.of(
            effect(),
            "scattered",
            v -> new ScatteredOffset(new RangeOffset(v[0]), v[1]),
            OFFSET,
            Parameter.of("scatter_share", 0, 0, MOST_SCATTER, 0.1)));
  }

  /** An offset under the level law may leave what the near gate cuts off. */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    SonarSpec sensor = setup.sensor();
    double soft = Math.max(LEAST_SOFT_M, sensor.rangeNoiseM());
    List<Form> forms = new ArrayList<>(forms(setup, sensors));
    forms.add(
        Form.of(effect(), "gated", v -> new GatedOffset(new RangeOffset(v[0]), soft), OFFSET));
    return forms;
  }

  /** That by which most readings are beyond a distance, beside the usual ones. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    DoubleStream beyond =
        clues.echoesInCone().mapToDouble(i -> clues.log().rangeM(i) - clues.nearestM(i));
    List<List<Double>> tries = Tries.of(form);
    List<Double> offsets = new ArrayList<>(tries.get(0));
    offsets.addAll(Modes.of(beyond, MODE_M, MODES));
    tries.set(0, offsets);
    return Tries.combined(form, tries);
  }

  /** 1 cm is what cheap sensors are specified to. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "constant", setup, log.sensors()).orElseThrow(), 0, 0.01));
  }

  /** An offset that scatters is one that is put in place anew. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !log.isRepeated() || form.parameters().size() == 1;
  }

  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.alikeInRange(effect());
  }

  @Override
  public String remedy(FittedValues values) {
    double offset = values.value("offset_m");
    return text(
        offset < 0 ? "add %.1f cm to every reading" : "subtract %.1f cm from every reading",
        100 * Math.abs(offset));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MOVES_RANGES, Trait.LAW_OF_RANGES);
  }
}
