package simbad.experiments.run;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simbad.obstacles.SonarBelt;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneFile;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.NamedSensorModel;
import simbad.sonar.model.SensorModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Sensor;

/**
 * The sensors that a run compares, by the names of the command line; equal when their names are.
 */
public final class SensorKind {
  /** Number of sonars on the belt; with half angles over 15 degrees their cones look all round. */
  public static final int SONARS = 12;

  /** Simbad's sensor as the thesis describes it: every obstacle is heard up to 2.5 m. */
  public static final SensorKind ORIGINAL =
      new SensorKind(
          "original", "cone, every obstacle heard up to 2.5 m", belt(DetectionRule.ORIGINAL));

  /** Simbad's sensor as its program has it: thin rays of 2.5 m. */
  public static final SensorKind RAY =
      new SensorKind("ray", "Simbad's thin rays of 2.5 m", SensorKind::rays);

  /** Cone and shadow, the sensor inside the shadow. */
  public static final SensorKind SHADOW =
      new SensorKind(
          "shadow",
          "obstacle in the cone, sensor in the detection shadow",
          belt(DetectionRule.SHADOW));

  /** Cone and shadow overlap anywhere. */
  public static final SensorKind OVERLAP =
      new SensorKind("overlap", "cone and detection shadow overlap", belt(DetectionRule.OVERLAP));

  /** The shadow sensor with the nominal model's noise. */
  public static final SensorKind NOISY =
      new SensorKind(
          "noisy", "nominal model: misses, soft threshold, range noise", belt(DetectionRule.NOISY));

  /** The level model without its scatter. */
  public static final SensorKind LEVEL =
      new SensorKind(
          "level",
          "level model: the echo reaches the receiver's threshold",
          belt(DetectionRule.LEVEL));

  /** The level model with its scatter. */
  public static final SensorKind LEVEL_NOISY =
      new SensorKind(
          "level-noisy",
          "level model: misses, excess and range scatter",
          belt(DetectionRule.LEVEL_NOISY));

  private final String word;
  private final String meaning;
  private final BeltMaker maker;
  private final Optional<FittedModel> model;
  private final Optional<RobotKind> robot;

  /** Makes the belt of a sensor, all transducers at its centre. */
  @FunctionalInterface
  private interface BeltMaker {
    RangeSensorBelt belt(SonarSpec spec, RandomGenerator random);
  }

  private SensorKind(String word, String meaning, BeltMaker maker) {
    this.word = word;
    this.meaning = meaning;
    this.maker = maker;
    model = Optional.empty();
    robot = Optional.empty();
  }

  private SensorKind(SensorKind hearing, RobotKind robot) {
    word = hearing.word + "-on-" + robot.name();
    meaning = hearing.meaning + "; on a robot that moves as " + robot.name();
    maker = hearing.maker;
    model = hearing.model;
    this.robot = Optional.of(robot);
  }

  private SensorKind(String word, FittedModel fitted) {
    this.word = word;
    meaning = DiagnosedMeaning.of(fitted);
    maker = (spec, random) -> new SonarBelt(SONARS, fitted.setup().sensor(), fitted, random);
    model = Optional.of(fitted);
    robot = Optional.empty();
  }

  private static BeltMaker belt(DetectionRule rule) {
    return (spec, random) -> new SonarBelt(SONARS, spec, rule, random);
  }

  private static RangeSensorBelt rays(SonarSpec spec, RandomGenerator random) {
    return new RangeSensorBelt(
        0, 0, (float) DetectionRule.ORIGINAL_RANGE_M, SONARS, RangeSensorBelt.TYPE_SONAR, 0);
  }

  /** Returns the sensors that need no further word, in the order in which help lists them. */
  public static List<SensorKind> plain() {
    return List.of(ORIGINAL, RAY, SHADOW, OVERLAP, NOISY, LEVEL, LEVEL_NOISY);
  }

  /**
   * Makes the sensor of a fitted model.
   *
   * @param name of the model; what cannot stand in a file's name becomes a hyphen
   * @param model which brings its own sensor's figures along
   */
  public static SensorKind diagnosed(String name, FittedModel model) {
    return new SensorKind("diagnosed-" + name.replaceAll("[^A-Za-z0-9_.-]", "-"), model);
  }

  /**
   * Makes the sensor of any model.
   *
   * @param name in files and tables; what cannot stand in a file's name becomes a hyphen
   * @param model with the figures of the run's sonar
   */
  public static SensorKind of(String name, SensorModel model) {
    return of(name, model, "model " + name);
  }

  private static SensorKind of(String name, SensorModel model, String meaning) {
    return new SensorKind(
        name.replaceAll("[^A-Za-z0-9_.-]", "-"),
        meaning,
        (spec, random) -> new SonarBelt(SONARS, spec, model, random));
  }

  /**
   * Returns the same sensor on a robot that moves otherwise than it is told. Its name in files and
   * tables has the robot's behind it.
   */
  public SensorKind on(RobotKind moving) {
    return new SensorKind(this, moving);
  }

  /** Returns the robot that it sits on; empty for one that does what it is told. */
  public Optional<RobotKind> robot() {
    return robot;
  }

  /** Returns the name of the sensor alone, without the robot that it sits on. */
  public String hearing() {
    return robot
        .map(moving -> word.substring(0, word.length() - ("-on-" + moving.name()).length()))
        .orElse(word);
  }

  /** Returns the name in files and tables. */
  public String word() {
    return word;
  }

  /** Returns in a few words when this sensor hears an obstacle. */
  public String meaning() {
    return meaning;
  }

  /** Returns the fitted model of a diagnosed sensor. */
  public Optional<FittedModel> model() {
    return model;
  }

  /**
   * Returns the plain sensors, then those that jars bring, by name. Of two with one name the first
   * stands.
   *
   * @throws java.util.ServiceConfigurationError if a jar names a model that it does not hold
   */
  public static List<SensorKind> all() {
    Stream<SensorKind> ofJars =
        ServiceLoader.load(NamedSensorModel.class).stream()
            .map(ServiceLoader.Provider::get)
            .sorted(Comparator.comparing(NamedSensorModel::name))
            .map(model -> of(model.name(), model, model.meaning()));
    return Stream.concat(plain().stream(), ofJars).distinct().toList();
  }

  /**
   * Finds a sensor that needs no further word: a plain one, or one that a jar brings.
   *
   * @param word as on the command line
   */
  public static Optional<SensorKind> find(String word) {
    // A plain one needs no look into jars.
    Optional<SensorKind> plain = named(word, plain());
    return plain.isPresent() ? plain : named(word, all());
  }

  private static Optional<SensorKind> named(String word, List<SensorKind> kinds) {
    return kinds.stream().filter(kind -> kind.word.equals(word)).findFirst();
  }

  /**
   * Reads a sensor of the command line: a name, or the folder of a diagnosis.
   *
   * @param word as {@link #find}, or "diagnosed:" and a folder
   * @return empty for a word that names no sensor
   * @throws DataFormatException if a diagnosis' files are missing or wrong
   */
  public static Optional<SensorKind> read(String word) throws DataFormatException {
    Optional<String> folder = DiagnosedFolder.in(word);
    if (folder.isEmpty()) {
      return find(word);
    }
    Path path = Path.of(folder.get());
    return Optional.of(diagnosed(DiagnosedFolder.name(path).orElse(""), path));
  }

  /**
   * Reads the sensor that a diagnosis left.
   *
   * @param name that it goes by
   * @param folder of the diagnosis
   * @throws DataFormatException if one of its files is missing or wrong
   */
  public static SensorKind diagnosed(String name, Path folder) throws DataFormatException {
    SensingSetup setup = SceneFile.read(folder.resolve("scene.json"));
    return diagnosed(name, ModelFile.read(folder.resolve("model.json"), setup));
  }

  /** Returns all names of the command line, separated by commas. */
  public static String words() {
    return all().stream().map(SensorKind::word).collect(Collectors.joining(", "))
        + ", "
        + DiagnosedFolder.PREFIX
        + "DIR";
  }

  /**
   * Makes a belt of this sensor, {@value #SONARS} transducers at its centre.
   *
   * @param spec figures of the sonar; a fitted model brings its own
   * @param random source of chance
   */
  public RangeSensorBelt belt(SonarSpec spec, RandomGenerator random) {
    return maker.belt(spec, random);
  }

  /** The same for single pings at places that have nothing to do with each other. */
  RangeSensorBelt beltWithoutMemory(SonarSpec spec, RandomGenerator random) {
    return model
        .<RangeSensorBelt>map(
            fitted -> new SonarBelt(SONARS, fitted.setup().sensor(), forgetful(fitted), random))
        .orElseGet(() -> belt(spec, random));
  }

  private static SensorModel forgetful(SensorModel model) {
    return (spec, scene, random) -> {
      Sensor sensor = model.bind(spec, scene, random);
      return (poses, timeS, readings) -> {
        sensor.reset();
        sensor.ping(poses, timeS, readings);
      };
    };
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SensorKind that && word.equals(that.word);
  }

  @Override
  public int hashCode() {
    return word.hashCode();
  }

  @Override
  public String toString() {
    return word;
  }
}
