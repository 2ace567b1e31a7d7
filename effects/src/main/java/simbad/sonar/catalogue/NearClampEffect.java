package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.NearClamp;
import simbad.sonar.change.NearLimit;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Ranges below a least value are reported as that value. */
public final class NearClampEffect implements Definition {
  /** A limit may be a little less than what the scene believes to be the least range. */
  private static final double NEARLY = 0.8;

  /** The greatest least range that data sheets state (MaxBotix HRXL-MaxSonar-WR: 0.5 m). */
  private static final double MOST_M = 0.5;

  @Override
  public Effect effect() {
    return Effect.NEAR_CLAMP;
  }

  @Override
  public String happens() {
    return "ranges below a smallest value are reported as that value";
  }

  @Override
  public String briefly() {
    return "short ranges are reported as one smallest value";
  }

  @Override
  public String cause() {
    return "a sensor or a driver that never reports less than its minimum range";
  }

  /** A sensor with a near limit hears what is nearer, which a scene may call its blind zone. */
  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    Form clamp = Form.of(effect(), "clamp", v -> new NearClamp(v[0]), least(setup, 0));
    // Who reports less than the blind zone's end hears nearer than believed, and clamps nothing.
    double from = NEARLY * setup.sensor().minRangeM();
    return from > 0
        ? List.of(clamp, Form.of(effect(), "limit", v -> new NearLimit(v[0]), least(setup, from)))
        : List.of(clamp);
  }

  private static Parameter least(SensingSetup setup, double lowM) {
    return Parameter.of("least_m", 0, lowM, setup.sensor().maxRangeM(), 0.1, 0.2, 0.35, 0.6);
  }

  /** At the least reading there is. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    PingLog log = clues.log();
    List<Double> least = new ArrayList<>(form.parameters().get(0).tries());
    IntStream.range(0, log.size())
        .filter(log::echo)
        .mapToDouble(log::rangeM)
        .min()
        .ifPresent(
            range -> {
              least.add(range);
              least.add(range + 0.005);
            });
    return Tries.product(form, least);
  }

  /** Sensors are specified to be blind up to 0.3 m. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(
            Forms.find(effect(), "clamp", setup, log.sensors()).orElseThrow(),
            0,
            Math.max(0.3, 1.5 * setup.sensor().minRangeM())));
  }

  /** Rangers are sold that report no less than 15 to 50 cm; none that ends beyond. */
  @Override
  public boolean isByDesign(Form form, double... values) {
    return values[0] <= MOST_M;
  }

  /** A scene has no field for it. */
  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    return Optional.empty();
  }

  @Override
  public String remedy(FittedValues values) {
    return text("read %.3f m as 'this near or nearer', not as a distance", values.value("least_m"));
  }
}
