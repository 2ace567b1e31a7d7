package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.MixedMultipath;
import simbad.sonar.change.Multipath;
import simbad.sonar.change.TailedMultipath;
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

/** Some echoes arrive by a longer way than the direct one. */
public final class MultipathEffect implements Definition {
  private static final Parameter SMALL_SHARE = Parameter.of("share", 0, 0, 0.7, 0.03, 0.1, 0.3);
  private static final Parameter EXTRA = Parameter.of("extra_m", 0, 0.02, 2, 0.1, 0.3, 0.6);
  private static final Parameter FACTOR = Parameter.of("factor", 1, 1.02, 3, 1.2, 1.5, 2);

  /**
   * Spread of a detour over its length, and for one in proportion over that of an echo at 1 m: a
   * way that scatters by more than it is longer would be noise.
   */
  private static final double MOST_SPREAD = 0.5;

  private static final Parameter SPREAD = Parameter.of("spread_share", 0, 0, MOST_SPREAD, 0.1);

  /** Of detours, over their length. */
  private static final List<Double> SPREADS = List.of(0.03, 0.25);

  private static final int MODES = 4;

  @Override
  public Effect effect() {
    return Effect.MULTIPATH;
  }

  @Override
  public String happens() {
    return "some echoes take a longer way than the direct one, so they read too long";
  }

  @Override
  public String briefly() {
    return "some echoes take a longer way than the direct one";
  }

  @Override
  public String cause() {
    return "walls, corners or the floor beside the direct way, which reflect the sound";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(effect(), "added", v -> added(v[0], v[1], v[2]), SMALL_SHARE, EXTRA, SPREAD),
        Form.of(effect(), "factor", v -> scaled(v[0], v[1], v[2]), SMALL_SHARE, FACTOR, SPREAD),
        Form.of(
            effect(),
            "tail",
            v -> new TailedMultipath(v[0], v[1]),
            SMALL_SHARE,
            Parameter.of("mean_extra_m", 0, 0.05, 1, 0.08, 0.2, 0.5)),
        Form.of(
            effect(),
            "both",
            v -> new MixedMultipath(added(v[0], v[1], v[4]), scaled(v[2], v[3], v[4])),
            SMALL_SHARE,
            EXTRA,
            Parameter.of("scaled_share", 0, 0, 0.7, 0.1),
            FACTOR,
            SPREAD));
  }

  private static Multipath added(double share, double extraM, double spread) {
    return new Multipath(share, 1, extraM, spread * extraM);
  }

  private static Multipath scaled(double share, double factor, double spread) {
    return new Multipath(share, factor, 0, spread * (factor - 1));
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    List<Double> shares = SMALL_SHARE.tries();
    return switch (form.name()) {
      case "added" -> Tries.product(form, shares, longerBy(clues), SPREADS);
      case "factor" -> Tries.product(form, shares, longerTimes(clues), SPREADS);
      case "tail" -> Tries.all(form);
      default ->
          Tries.product(
              form, List.of(0.1), longerBy(clues), List.of(0.1), longerTimes(clues), List.of(0.03));
    };
  }

  /** Echoes that came by a longer way than to the nearest obstacle. */
  private static IntStream late(Clues clues) {
    return clues.echoesInCone().filter(i -> clues.log().rangeM(i) > clues.nearestM(i) + 0.02);
  }

  private static List<Double> longerBy(Clues clues) {
    return Modes.of(
        late(clues).mapToDouble(i -> clues.log().rangeM(i) - clues.nearestM(i)), 0.04, MODES);
  }

  private static List<Double> longerTimes(Clues clues) {
    return Modes.of(
        late(clues).mapToDouble(i -> clues.log().rangeM(i) / clues.nearestM(i)), 0.04, MODES);
  }

  /** A twentieth of the echoes. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "added", setup, log.sensors()).orElseThrow(), 0, 0.05));
  }

  @Override
  public String remedy(FittedValues values) {
    String longer =
        values.has("mean_extra_m")
            ? text("by %.2f m on average", values.value("mean_extra_m"))
            : values.has("extra_m")
                ? text("by %.2f m", values.value("extra_m"))
                : text("%.2f times as far", values.value("factor"));
    return text(
        "cover or move what reflects beside the way, and take the least of some readings:"
            + " %.0f %% of the echoes read too far, %s",
        100 * values.value("share"), longer);
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP);
  }
}
