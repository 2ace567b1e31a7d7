package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.LatePose;
import simbad.sonar.change.Latency;
import simbad.sonar.change.PingDelay;
import simbad.sonar.change.ScatteredLatency;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** A reading belongs to an earlier pose, or to a later one where poses come late. */
public final class LatencyEffect implements Definition {
  private static final double MOST_DELAY_S = 5;
  private static final double MOST_PINGS = 30;

  /** Where a robot goes from there is not known for longer. */
  private static final double MOST_LATE_S = 1;

  private static final String LATE = "pose_delay_s";

  @Override
  public Effect effect() {
    return Effect.LATENCY;
  }

  @Override
  public String happens() {
    return "readings and poses are not of the same time";
  }

  @Override
  public String cause() {
    return "a filter or a buffer, or readings or poses that are stamped when they arrive";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double period = setup.sensor().updatePeriodS();
    double most = Math.max(MOST_DELAY_S, MOST_PINGS * period);
    Parameter delay = Parameter.of("delay_s", 0, 0, most, period, 2 * period, 0.3, 0.6, 1.2);
    return List.of(
        Form.of(effect(), "time", v -> new Latency(v[0]), delay),
        Form.of(
            effect(),
            "pings",
            v -> new PingDelay(v[0]),
            Parameter.of("pings", 0, 0, MOST_PINGS, 1, 2, 4, 8)),
        Form.of(
            effect(),
            "scattered",
            v -> new ScatteredLatency(new Latency(v[0]), v[1]),
            delay,
            Parameter.of("scatter_pings", 0, 0, 3, 0.2)),
        Form.of(
            effect(),
            "poses",
            v -> new LatePose(v[0]),
            Parameter.of(LATE, 0, 0, MOST_LATE_S, 0.06, 0.15, 0.3, 0.6)));
  }

  /** Of one pass past one obstacle, a servo that is read late looks like one that is turned. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !log.isOnePass();
  }

  /** 50 ms. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "time", setup, log.sensors()).orElseThrow(), 0, 0.05));
  }

  @Override
  public String remedy(FittedValues values) {
    if (values.has(LATE)) {
      return text(
          "stamp poses with the time at which they were so, which is %.3f s earlier",
          values.value(LATE));
    }
    String late =
        values.has("delay_s")
            ? text("%.3f s", values.value("delay_s"))
            : text("%.1f pings", values.value("pings"));
    return text(
        "stamp readings with the time of the ping, not of their arrival, which is %s later", late);
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
