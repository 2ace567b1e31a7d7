package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.scene.SonarSpec;

/** The forms of effects in which a reading hangs on what was read or heard before. */
final class MemoryForms {
  /** Fewer ghosts than these are no effect: a form as free as this one finds some in any log. */
  private static final Parameter GHOSTS = Parameter.of("share", 0, 0.03, 1, 0.1, 0.4);

  private static final double FOREVER_S = 1e9;
  private static final double MOST_HOLD_S = 20;
  private static final double MOST_PINGS = 30;

  private final List<Form> forms = new ArrayList<>();

  private MemoryForms() {}

  static List<Form> all(SonarSpec sensor) {
    MemoryForms memory = new MemoryForms();
    memory.stale(sensor);
    memory.hysteresis();
    memory.ghosts();
    return memory.forms;
  }

  private void add(Effect effect, String name, Form.Maker maker, Parameter... parameters) {
    forms.add(new Form(effect, name, List.of(parameters), maker));
  }

  private void stale(SonarSpec sensor) {
    add(
        Effect.STALE_READING,
        "count",
        v -> new StaleReading(v[0], FOREVER_S, 1),
        Parameter.of("pings", 0, 0, MOST_PINGS, 1, 2, 3, 5, 8, 14));
    double period = sensor.updatePeriodS();
    add(
        Effect.STALE_READING,
        "time",
        v -> new StaleReading(HiddenState.MOST, v[0], 1),
        Parameter.of(
            "hold_s",
            0,
            0,
            Math.max(MOST_HOLD_S, MOST_PINGS * period),
            1.5 * period,
            2.5 * period,
            4.5 * period,
            9.5 * period));
    add(
        Effect.STALE_READING,
        "fading",
        v -> new StaleReading(HiddenState.MOST, FOREVER_S, v[0]),
        Parameter.of("chance", 0, 0, 0.98, 0.3, 0.6, 0.85));
  }

  private void hysteresis() {
    Parameter gap = Parameter.of("gap", 0, 0, 0.7, 0.05, 0.15, 0.3);
    add(Effect.HYSTERESIS, "pick-up", v -> new Hysteresis(1 - v[0], 1), gap);
    add(Effect.HYSTERESIS, "hold", v -> new Hysteresis(1, 1 + v[0]), gap);
    add(
        Effect.HYSTERESIS,
        "metres",
        v -> new Hysteresis(1, 1, v[0]),
        Parameter.of("pick_up_m", 0, 0, 2, 0.05, 0.15, 0.4));
    add(Effect.HYSTERESIS, "both", v -> new Hysteresis(1 - v[0] / 2, 1 + v[0] / 2), gap);
  }

  private void ghosts() {
    Parameter spread = Parameter.of("spread_m", 0, 0, 0.1, 0.002);
    add(
        Effect.PREVIOUS_PING,
        "shift",
        v -> new PreviousPing(v[0], 1, v[1], v[2]),
        GHOSTS,
        Parameter.of("shift_m", 0, 0.02, 5, 0.2, 0.5, 1),
        spread);
    add(
        Effect.PREVIOUS_PING,
        "factor",
        v -> new PreviousPing(v[0], v[1], 0, v[2]),
        GHOSTS,
        Parameter.of("factor", 1, 0.05, 0.96, 0.3, 0.5, 0.8),
        spread);
    Parameter shift = Parameter.of("shift_m", 0, -0.3, 5, -0.05, 0.05);
    add(
        Effect.PREVIOUS_PING,
        "line",
        v -> new PreviousPing(v[0], v[1], v[2], v[3]),
        GHOSTS,
        Parameter.of("factor", 1, 0.05, 2.2, 0.3, 0.5, 0.8, 2),
        shift,
        spread);
    add(
        Effect.PREVIOUS_PING,
        "nearer",
        v -> new NearerByPrevious(v[0], v[1], v[2], v[3], v[4]),
        GHOSTS,
        Parameter.of("own_factor", 1, 0.5, 2.2, 1, 2),
        Parameter.of("before_factor", 0, -1.5, 1, -0.3, -1),
        Parameter.of("shift_m", 0, -1, 3, 0, 0.2),
        spread);
    ghostReading("read-nearer", true, shift, spread);
    ghostReading("read", false, shift, spread);
  }

  private void ghostReading(String name, boolean onlyNearer, Parameter shift, Parameter spread) {
    add(
        Effect.PREVIOUS_PING,
        name,
        v -> new GhostReading(v[0], v[1], v[2], v[3], onlyNearer),
        GHOSTS,
        Parameter.of("factor", 1, 0.05, 2.2, 0.5, 1, 2),
        shift,
        spread);
  }
}
