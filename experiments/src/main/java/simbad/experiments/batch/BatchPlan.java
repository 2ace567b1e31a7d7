package simbad.experiments.batch;

import java.math.BigInteger;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.SensorFile;
import simbad.sonar.scene.SonarSpec;

/**
 * A spec with the contents of its files: which run every number means. The seed changes fastest,
 * then speed, controller, effects, sensor file, robot, sensor, and the scene slowest. Thread-safe.
 */
final class BatchPlan {
  /** More is a slip, and would take weeks. */
  static final long GREATEST_RUNS = 10_000_000;

  private final BatchSpec spec;
  private final List<BatchScene> scenes;
  private final List<SensorChoice> sensors;
  private final List<RobotChoice> robots;
  private final List<SonarChoice> sonars;
  private final List<EffectList> effects;
  private final MixedRadix radix;
  private final Optional<Permutation> order;

  private BatchPlan(
      BatchSpec spec,
      List<BatchScene> scenes,
      List<SensorChoice> sensors,
      List<RobotChoice> robots,
      List<SonarChoice> sonars,
      MixedRadix radix) {
    this.spec = spec;
    this.scenes = List.copyOf(scenes);
    this.sensors = List.copyOf(sensors);
    this.robots = List.copyOf(robots);
    this.sonars = List.copyOf(sonars);
    this.effects = spec.effects().stream().map(EffectList::new).toList();
    this.radix = radix;
    this.order =
        spec.sample()
            .map(sample -> new Permutation(radix.product().longValueExact(), sample.seed()));
  }

  /**
   * Reads the files that a spec names.
   *
   * @param spec what it says
   * @param place where the files are
   * @throws DataFormatException naming file, line and field of the first fault; for a product that
   *     is too large too
   */
  static BatchPlan read(BatchSpec spec, InputPlace place) throws DataFormatException {
    List<BatchScene> scenes = SceneList.read(spec, place);
    List<SensorChoice> sensors = sensors(spec, place);
    List<RobotChoice> robots = robots(spec, place);
    List<SonarChoice> sonars = sonars(spec, place);
    MixedRadix radix =
        new MixedRadix(
            List.of(
                (long) scenes.size(),
                (long) sensors.size(),
                (long) robots.size(),
                (long) sonars.size(),
                (long) Math.max(1, spec.effects().size()),
                spec.controllers().size(),
                spec.speedsMPerS().size(),
                spec.seeds().size()));
    checkRuns(spec, radix.product());
    BatchPlan plan = new BatchPlan(spec, scenes, sensors, robots, sonars, radix);
    plan.checkNames();
    return plan;
  }

  private static List<SensorChoice> sensors(BatchSpec spec, InputPlace place)
      throws DataFormatException {
    List<SensorChoice> sensors = new ArrayList<>();
    for (int i = 0; i < spec.sensors().size(); i++) {
      sensors.add(SensorChoice.read(spec.sensors().get(i), i + 1, place));
    }
    return sensors;
  }

  private static List<RobotChoice> robots(BatchSpec spec, InputPlace place)
      throws DataFormatException {
    List<RobotChoice> robots = new ArrayList<>();
    for (int i = 0; i < spec.robots().size(); i++) {
      robots.add(RobotChoice.read(spec.robots().get(i), i + 1, place));
    }
    return robots.isEmpty() ? List.of(RobotChoice.AS_TOLD) : robots;
  }

  private static List<SonarChoice> sonars(BatchSpec spec, InputPlace place)
      throws DataFormatException {
    List<SonarChoice> sonars = new ArrayList<>();
    for (int i = 0; i < spec.sensorFiles().size(); i++) {
      JsonInput where = spec.sensorFiles().get(i);
      Path name = InputPlace.name(where, where.text());
      Path file = place.of(InputFiles.SENSOR_FILES, i + 1, name);
      sonars.add(
          new SonarChoice(
              String.valueOf(name.normalize().getFileName()), Optional.of(SensorFile.read(file))));
    }
    return sonars.isEmpty() ? List.of(SonarChoice.OWN) : sonars;
  }

  private static void checkRuns(BatchSpec spec, BigInteger product) throws DataFormatException {
    BigInteger most = BigInteger.valueOf(GREATEST_RUNS);
    if (spec.sample().isEmpty() && product.compareTo(most) > 0) {
      throw spec.fault(
          product + " runs, expected at most " + most + "; \"sample\" takes some of them");
    }
    if (product.compareTo(BigInteger.valueOf(Permutation.GREATEST_SIZE)) > 0) {
      throw spec.fault(product + " runs to take a sample of, expected at most 2^62");
    }
    BigInteger sample = BigInteger.valueOf(spec.sample().map(Sample::runs).orElse(1L));
    if (sample.compareTo(product.min(most)) > 0) {
      throw spec.fault("a sample of " + sample + " runs, expected at most " + product.min(most));
    }
  }

  /** Two that are called the same could not be told apart in the results. */
  private void checkNames() throws DataFormatException {
    checkDistinct("obstacles or scenes", scenes.stream().map(BatchScene::label).toList());
    checkDistinct("sensors", sensors.stream().map(choice -> choice.kind().word()).toList());
    checkDistinct("robots", robots.stream().map(RobotChoice::label).toList());
    checkDistinct("sensor_files", sonars.stream().map(SonarChoice::label).toList());
  }

  private void checkDistinct(String dimension, List<String> names) throws DataFormatException {
    Set<String> before = new HashSet<>();
    for (String name : names) {
      if (!before.add(name)) {
        throw spec.fault("two of its " + dimension + " are called " + name);
      }
    }
  }

  /**
   * Checks that all effects are defined for all sensors and scenes.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  void checkEffects() throws DataFormatException {
    for (EffectList list : effects) {
      for (BatchScene scene : scenes) {
        for (SonarChoice sonar : sonars) {
          for (SensorChoice sensor : sensors) {
            sensor.with(list, sonar.in(scene), scene);
          }
        }
      }
    }
  }

  BatchSpec spec() {
    return spec;
  }

  /** How many runs there are. */
  long size() {
    return spec.sample().map(Sample::runs).orElseGet(() -> radix.product().longValueExact());
  }

  /**
   * Finds a run.
   *
   * @param number in [0, size)
   */
  BatchRun run(long number) {
    long[] digits = radix.digits(order.map(o -> o.at(number)).orElse(number));
    BatchScene scene = scenes.get(Math.toIntExact(digits[0]));
    SensorChoice sensor = sensors.get(Math.toIntExact(digits[1]));
    SonarChoice sonar = sonars.get(Math.toIntExact(digits[3]));
    SonarSpec figures = sonar.in(scene);
    SensorKind kind = sensor.kind();
    String atWork = "";
    if (!effects.isEmpty()) {
      EffectList list = effects.get(Math.toIntExact(digits[4]));
      try {
        kind = sensor.with(list, figures, scene);
        atWork = EffectList.label(list.model(figures, scene));
      } catch (DataFormatException e) {
        throw new IllegalStateException(e);
      }
    }
    Circuit circuit =
        new Circuit(
            scene.circled(),
            scene.around(),
            robots.get(Math.toIntExact(digits[2])).under(kind),
            figures,
            spec.speedsMPerS().at(digits[6]),
            Optional.empty(),
            spec.seeds().at(digits[7]));
    return new BatchRun(
        number,
        scene,
        sonar.label(),
        atWork,
        spec.controllers().at(digits[5]),
        spec.pace(),
        circuit);
  }
}
