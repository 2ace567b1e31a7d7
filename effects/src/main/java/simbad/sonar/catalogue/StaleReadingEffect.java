package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.StaleReading;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** When an echo is missed, the last reading is repeated for a while. */
public final class StaleReadingEffect implements Definition {
  private static final double MOST_HOLD_S = 20;
  private static final double MOST_PINGS = 30;

  @Override
  public Effect effect() {
    return Effect.STALE_READING;
  }

  @Override
  public String happens() {
    return "when an echo is missed, the last reading is repeated for a while";
  }

  @Override
  public String briefly() {
    return "the last reading is repeated when an echo is missed";
  }

  @Override
  public String cause() {
    return "a driver or a filter that holds its last value";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double period = setup.sensor().updatePeriodS();
    double most = Math.max(MOST_HOLD_S, MOST_PINGS * period);
    return List.of(
        Form.of(
            effect(),
            "count",
            v -> StaleReading.ofPings(v[0]),
            Parameter.of("pings", 0, 0, MOST_PINGS, 1, 2, 3, 5, 8, 14)),
        Form.of(
            effect(),
            "time",
            v -> StaleReading.ofTime(v[0]),
            Parameter.of(
                "hold_s", 0, 0, most, 1.5 * period, 2.5 * period, 4.5 * period, 9.5 * period)),
        Form.of(
            effect(),
            "fading",
            v -> StaleReading.ofChance(v[0]),
            Parameter.of("chance", 0, 0, 0.98, 0.3, 0.6, 0.85)));
  }

  /** One ping. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "count", setup, log.sensors()).orElseThrow(), 0, 1));
  }

  @Override
  public String remedy(FittedValues values) {
    String held =
        values.has("hold_s")
            ? text("for up to %.2f s", values.value("hold_s"))
            : values.has("pings")
                ? text("for up to %.0f pings", values.value("pings"))
                : text("in %.0f %% of the pings", 100 * values.value("chance"));
    return text("report a missed echo as such: the reading before is repeated %s", held);
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_A_REST);
  }
}
