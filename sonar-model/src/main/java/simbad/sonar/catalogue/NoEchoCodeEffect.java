package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.NoEchoCode;
import simbad.sonar.effect.Parameter;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.scene.SensingSetup;

/** A number stands for "no echo". */
public final class NoEchoCodeEffect implements Definition {
  /** Nobody takes a number for "no echo" that an echo may well have. */
  private static final double CODE_FROM = 0.95;

  /** Numbers for "no echo" end where a log is one of another unit. */
  private static final double MOST_CODE_M = 100;

  private static final int MODES = 4;

  /** Fewer readings of one value are a coincidence. */
  private static final int LEAST_CODES = 3;

  @Override
  public Effect effect() {
    return Effect.NO_ECHO_CODE;
  }

  @Override
  public String happens() {
    return "a number stands for no echo";
  }

  @Override
  public String cause() {
    return "a driver that reports 0, its maximum or a number of its own where nothing was heard";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double most = setup.sensor().maxRangeM();
    double near = Math.max(1e-3, setup.sensor().minRangeM() / 2);
    double far = Math.max(MOST_CODE_M, most);
    return List.of(
        code("near", Parameter.of("code_m", most, 0, near, 0)),
        code("far", Parameter.of("code_m", 0, CODE_FROM * most, far, most)));
  }

  private Form code(String name, Parameter code) {
    return Form.of(
        effect(),
        name,
        v -> new NoEchoCode(v[0], v[1], v[2]),
        code.asClosed(),
        Parameter.of("share", 0, 0, 1, 0.9).asClosed(),
        Parameter.of("lost_share", 0, 0, 0.95, 0, 0.1, 0.4));
  }

  /** Numbers that strange readings have again and again, to the millimetre. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    Parameter code = form.parameters().get(0);
    List<List<Double>> tries = Tries.of(form);
    tries.set(0, Modes.of(clues.strangeRangesM().filter(code::permits), 1e-3, MODES));
    return Tries.combined(form, tries);
  }

  /**
   * Whether one number is read at least as often as no echo is. A number that stands for "no echo"
   * stands for most of them; with a rarer one beside it the form would be one of lost echoes.
   */
  @Override
  public boolean canShow(Form form, LogDesign design) {
    Parameter code = form.parameters().get(0);
    PingLog log = design.log();
    Map<Long, Integer> readings = new HashMap<>();
    int silent = 0;
    int most = 0;
    for (int ping = 0; ping < log.size(); ping++) {
      if (!log.echo(ping)) {
        silent++;
      } else if (code.permits(log.rangeM(ping))) {
        long millimetres = Math.round(1000 * log.rangeM(ping));
        most = Math.max(most, readings.merge(millimetres, 1, Integer::sum));
      }
    }
    return most >= Math.max(LEAST_CODES, silent);
  }

  /** A number for half of the silent pings. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "far", setup, log.sensors()).orElseThrow(), 1, 0.5));
  }

  @Override
  public String remedy(FittedValues values) {
    return text("read %.3f m as no echo, not as a distance", values.value("code_m"));
  }
}
