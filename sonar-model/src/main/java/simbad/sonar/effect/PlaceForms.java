package simbad.sonar.effect;

import static java.lang.Math.toRadians;
import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

/** The forms of effects on where sensors and obstacles are, and on each obstacle's thresholds. */
final class PlaceForms {
  private static final double MOST_THRESHOLD_M = 20;
  private static final double MOST_DELAY_S = 5;
  private static final double MOST_PINGS = 30;

  private final SensingSetup setup;
  private final List<String> sensors;
  private final List<Form> forms = new ArrayList<>();

  private PlaceForms(SensingSetup setup, List<String> sensors) {
    this.setup = setup;
    this.sensors = sensors;
  }

  static List<Form> all(SensingSetup setup, List<String> sensors) {
    PlaceForms places = new PlaceForms(setup, sensors);
    places.sensors();
    places.scene();
    places.poses();
    return places.forms;
  }

  private void add(Effect effect, String name, Form.Maker maker, Parameter... parameters) {
    forms.add(new Form(effect, name, List.of(parameters), maker));
  }

  private void sensors() {
    misaligned("all", Optional.empty());
    if (sensors.size() > 1) {
      sensors.forEach(sensor -> misaligned("only:" + sensor, Optional.of(sensor)));
    }
  }

  private void misaligned(String name, Optional<String> sensor) {
    add(
        Effect.BEAM_MISALIGNMENT,
        name,
        v -> new BeamMisalignment(toRadians(v[0]), sensor),
        Parameter.of("turn_deg", 0, -30, 30, -12, -6, -3, 3, 6, 12));
  }

  private void scene() {
    placed("all", Optional.empty());
    List<String> labels = Scenes.labels(setup.scene());
    for (int i = 0; i < labels.size(); i++) {
      if (labels.size() > 1) {
        placed("only:" + labels.get(i), Optional.of(labels.get(i)));
      }
      if (setup.scene().obstacles().get(i).detection() instanceof UniformDetection uniform) {
        shadowed(labels.get(i), i, uniform.greatestM());
      }
    }
    int[] uniform =
        IntStream.range(0, labels.size())
            .filter(i -> setup.scene().obstacles().get(i).detection() instanceof UniformDetection)
            .toArray();
    if (uniform.length > 1) {
      allShadowed(uniform);
    }
    if (labels.size() > 1 && uniform.length == labels.size()) {
      waved("waves", Optional.empty());
    }
  }

  private void placed(String name, Optional<String> only) {
    add(
        Effect.OBSTACLE_TURN,
        name,
        v -> new ObstacleTurn(toRadians(v[0]), only),
        Parameter.of("turn_deg", 0, -180, 180, -30, -20, -12, -7, -3, 3, 7, 12, 20, 30).asClosed());
    add(
        Effect.OBSTACLE_OFFSET,
        name,
        v -> new ObstacleOffset(v[0], v[1], only),
        Parameter.of("x_m", 0, -1, 1, -0.06, 0, 0.06),
        Parameter.of("z_m", 0, -1, 1, -0.06, 0, 0.06));
  }

  private void shadowed(String label, int obstacle, double uniformM) {
    add(
        Effect.ORIENTATION_SHADOW,
        "table:" + label + "#" + obstacle,
        v -> new OrientationShadow(Optional.of(label), ThresholdTable.of(v)),
        thresholds("", uniformM).toArray(Parameter[]::new));
    waved("waves:" + label + "#" + obstacle, Optional.of(label));
  }

  /** Every obstacle that is believed uniform has a table of its own. */
  private void allShadowed(int... obstacles) {
    List<String> labels = Scenes.labels(setup.scene());
    List<Parameter> all = new ArrayList<>();
    for (int obstacle : obstacles) {
      double uniformM = setup.scene().obstacles().get(obstacle).detection().greatestM();
      all.addAll(thresholds(labels.get(obstacle) + "_", uniformM));
    }
    String numbers = Arrays.stream(obstacles).mapToObj(String::valueOf).collect(joining(","));
    add(
        Effect.ORIENTATION_SHADOW,
        "tables#" + numbers,
        v -> {
          List<OrientationShadow> each = new ArrayList<>();
          for (int i = 0; i < obstacles.length; i++) {
            double[] own = Arrays.copyOfRange(v, i * Forms.TABLE_SIZE, (i + 1) * Forms.TABLE_SIZE);
            each.add(
                new OrientationShadow(
                    Optional.of(labels.get(obstacles[i])), ThresholdTable.of(own)));
          }
          return new OrientationShadows(each);
        },
        all.toArray(Parameter[]::new));
  }

  private static List<Parameter> thresholds(String prefix, double uniformM) {
    return IntStream.range(0, Forms.TABLE_SIZE)
        .mapToObj(i -> prefix + "threshold_" + i * 360 / Forms.TABLE_SIZE + "_deg_m")
        .map(name -> thresholdM(name, uniformM))
        .toList();
  }

  private static Parameter thresholdM(String name, double uniformM) {
    double most = Math.max(MOST_THRESHOLD_M, 2 * uniformM);
    return Parameter.of(name, uniformM, 0, most, uniformM).asClosed();
  }

  /** A shadow of few lobes, which few readings tell of. */
  private void waved(String name, Optional<String> only) {
    List<Parameter> series = new ArrayList<>();
    series.add(Parameter.of("level", 0, -1, 1, 0).asClosed());
    for (int wave = 1; wave <= Forms.SHADOW_WAVES; wave++) {
      series.add(Parameter.of("cos_" + wave, 0, -1, 1, 0).asClosed());
      series.add(Parameter.of("sin_" + wave, 0, -1, 1, 0).asClosed());
    }
    add(
        Effect.ORIENTATION_SHADOW,
        name,
        v -> new BearingFactor(only, Arrays.stream(v).boxed().toList()),
        series.toArray(Parameter[]::new));
  }

  private void poses() {
    double period = setup.sensor().updatePeriodS();
    Parameter delay =
        Parameter.of(
            "delay_s",
            0,
            0,
            Math.max(MOST_DELAY_S, MOST_PINGS * period),
            period,
            2 * period,
            0.3,
            0.6,
            1.2);
    Parameter scatter = Parameter.of("scatter_pings", 0, 0, 3, 0.2);
    add(Effect.LATENCY, "time", v -> new Latency(v[0]), delay);
    Parameter pings = Parameter.of("pings", 0, 0, MOST_PINGS, 1, 2, 4, 8);
    add(Effect.LATENCY, "pings", v -> new PingDelay(v[0]), pings);
    add(
        Effect.LATENCY,
        "scattered",
        v -> new ScatteredLatency(new Latency(v[0]), v[1]),
        delay,
        scatter);
    add(
        Effect.ODOMETRY_SCALE,
        "path",
        v -> new OdometryScale(v[0]),
        Parameter.of("factor", 1, 0.5, 1.6, 0.9, 0.96, 1.04, 1.1));
    add(
        Effect.ODOMETRY_SCALE,
        "along",
        v -> new PathScale(v[0]),
        Parameter.of("factor", 1, 0.5, 1, 0.86, 0.9, 0.94, 0.98));
    drifts();
  }

  private void drifts() {
    Parameter drift = Parameter.of("rate_deg_s", 0, -5, 5, -1, -0.3, -0.1, 0.1, 0.3, 1);
    add(Effect.HEADING_DRIFT, "heading", v -> new HeadingDrift(toRadians(v[0]), false), drift);
    add(Effect.HEADING_DRIFT, "reckoned", v -> new HeadingDrift(toRadians(v[0]), true), drift);
    add(
        Effect.HEADING_DRIFT,
        "settling",
        v -> new HeadingDrift(toRadians(v[0] / v[1]), v[1], false),
        Parameter.of("turn_deg", 0, -60, 60, -15, -5, 5, 15),
        Parameter.of("settling_s", 10, 0.1, 1000, 1, 10, 40).asClosed());
    add(
        Effect.HEADING_DRIFT,
        "way",
        v -> new HeadingDriftByWay(toRadians(v[0])),
        Parameter.of("rate_deg_m", 0, -60, 60, -8, -3, -1, 1, 3, 8));
  }
}
