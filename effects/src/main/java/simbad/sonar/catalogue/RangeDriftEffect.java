package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.RangeDrift;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Ranges drift with the time since power-up. */
public final class RangeDriftEffect implements Definition {
  private static final String LINEAR = "linear";

  /** Parts as small as a sensor's board take as long to warm up, and housings. */
  private static final double LEAST_S = 2;

  private static final double MOST_S = 1e4;

  /** What is looked for at the end of a log, metres. */
  private static final double[] AT_END_M = {-0.05, -0.01, 0.01, 0.05};

  @Override
  public Effect effect() {
    return Effect.RANGE_DRIFT;
  }

  @Override
  public String happens() {
    return "ranges drift with the time since power-up";
  }

  @Override
  public String cause() {
    return "electronics, a clock or air that warms up";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    // Neutral is far: what has settled at once is no drift, and stands at an end of the search.
    Parameter settling =
        Parameter.of("settling_s", Double.POSITIVE_INFINITY, LEAST_S, MOST_S, 8, 60, 400);
    return List.of(
        Form.of(
            effect(),
            "settling",
            v -> new RangeDrift(v[0], 0, v[1]),
            Parameter.of("shift_m", 0, -1, 1, -0.05, -0.01, 0.01, 0.05),
            settling),
        Form.of(
            effect(),
            "scaled",
            v -> new RangeDrift(0, v[0], v[1]),
            Parameter.of("share", 0, -0.5, 0.5, -0.05, -0.01, 0.01, 0.05),
            settling),
        Form.of(
            effect(),
            LINEAR,
            v -> new RangeDrift(v[0], 0, Double.POSITIVE_INFINITY),
            Parameter.of("rate_m_s", 0, -0.1, 0.1, -1e-3, -1e-4, 1e-4, 1e-3)));
  }

  /** A rate is what leads to some centimetres in the time that the log takes. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    double lastsS = clues.log().lastsS();
    if (!form.name().equals(LINEAR) || !(lastsS > 0)) {
      return Definition.super.starts(form, clues);
    }
    Parameter rate = form.parameters().get(0);
    return DoubleStream.of(AT_END_M)
        .mapToObj(end -> new double[] {rate.clamp(end / lastsS)})
        .toList();
  }

  /** A centimetre in the end. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "settling", setup, log.sensors()).orElseThrow(), 0, 0.01));
  }

  /** It needs times. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return log.log().lastsS() > 0;
  }

  @Override
  public String remedy(FittedValues values) {
    return !values.has("settling_s")
        ? text(
            "calibrate the ranges again from time to time, or let the sensor warm up first: they"
                + " change by %+.4f m each minute",
            60 * values.value("rate_m_s"))
        : text(
            "let the sensor warm up for %.0f s before you measure", 3 * values.value("settling_s"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS, Trait.MOVES_SOME_RANGES);
  }
}
