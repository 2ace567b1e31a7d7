package simbad.experiments.batch;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.experiments.control.ControllerMaker;
import simbad.experiments.control.Controllers;
import simbad.experiments.control.EdgeFollowerMaker;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Pace;
import simbad.experiments.run.RunSettings;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/**
 * What a spec says, {@code format} "simbad-batch/1". The files that it names are not looked at yet.
 *
 * @param file how messages name the spec
 * @param obstacles names of the catalogue, tables, folders
 * @param scenes files
 * @param sensors words as on the command line; where the spec has none, original and shadow
 * @param robots words as on the command line, or "told"; empty: one that does what it is told
 * @param sensorFiles files; empty: each scene's own, for obstacles that of the SRF04
 * @param effects lists of effects; empty: none
 * @param makers the controllers' kinds
 * @param controllers kinds with their parameters' values
 * @param speedsMPerS of the robot
 * @param pace how much time robots are given for each decision
 * @param seeds of all chance
 * @param sample of the product; empty: all of it
 * @param traces whether they are kept
 */
record BatchSpec(
    Path file,
    List<JsonInput> obstacles,
    List<JsonInput> scenes,
    List<JsonInput> sensors,
    List<JsonInput> robots,
    List<JsonInput> sensorFiles,
    List<JsonInput> effects,
    List<ControllerMaker> makers,
    BatchChoices<ControllerSetting> controllers,
    BatchChoices<Double> speedsMPerS,
    Pace pace,
    BatchChoices<Long> seeds,
    Optional<Sample> sample,
    boolean traces) {
  private static final String FORMAT = "simbad-batch/1";

  private static final String SENSORS = "{\"sensors\": [\"original\", \"shadow\"]}";

  private static final String[] FIELDS = {
    "format",
    "obstacles",
    "scenes",
    "sensors",
    "robots",
    "sensor_files",
    "effects",
    "controllers",
    "speeds_m_per_s",
    "turn_rate_rad_per_s",
    "wait_s",
    "seeds",
    "sample",
    "traces"
  };

  /**
   * Reads a spec.
   *
   * @param file how messages name it
   * @param text JSON
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static BatchSpec parse(Path file, String text) throws DataFormatException {
    JsonInput root = JsonInput.parse(file, text);
    SpecFields.allowOnly(root, FIELDS);
    if (!root.text("format").equals(FORMAT)) {
      throw root.field("format").isNot("\"" + FORMAT + "\"");
    }
    BatchSpec spec =
        new BatchSpec(
            file,
            SpecFields.items(root, "obstacles"),
            SpecFields.items(root, "scenes"),
            SpecFields.items(
                root.has("sensors") ? root : JsonInput.parse(file, SENSORS), "sensors"),
            SpecFields.items(root, "robots"),
            SpecFields.items(root, "sensor_files"),
            SpecFields.items(root, "effects"),
            makers(root),
            controllers(root),
            speeds(root),
            pace(root),
            root.has("seeds") ? seeds(root.field("seeds")) : BatchChoices.of(List.of(1L)),
            root.has("sample") ? Optional.of(sample(root.field("sample"))) : Optional.empty(),
            root.has("traces") && root.field("traces").truth());
    if (spec.obstacles.isEmpty() && spec.scenes.isEmpty()) {
      throw root.fault("neither obstacles nor scenes, expected at least one");
    }
    return spec;
  }

  private static List<ControllerMaker> makers(JsonInput root) throws DataFormatException {
    List<ControllerMaker> makers = new ArrayList<>();
    for (JsonInput item : SpecFields.items(root, "controllers")) {
      makers.add(ControllerGrid.maker(item));
    }
    return makers.isEmpty() ? List.of(new EdgeFollowerMaker()) : makers;
  }

  private static BatchChoices<ControllerSetting> controllers(JsonInput root)
      throws DataFormatException {
    if (!root.has("controllers")) {
      ControllerMaker follower = new EdgeFollowerMaker();
      return BatchChoices.of(
          List.of(new ControllerSetting(follower, Controllers.standard(follower))));
    }
    BatchChoices<ControllerSetting> all = BatchChoices.of(List.of());
    for (JsonInput item : SpecFields.items(root, "controllers")) {
      try {
        all = all.then(ControllerGrid.read(item));
      } catch (ArithmeticException e) {
        throw item.fault("more than 2^63 combinations of parameters");
      }
    }
    return all;
  }

  private static BatchChoices<Double> speeds(JsonInput root) throws DataFormatException {
    if (!root.has("speeds_m_per_s")) {
      return BatchChoices.of(List.of(RunSettings.THESIS_SPEED_M_PER_S));
    }
    return BatchChoices.of(
        SpecFields.numbers(
            root.field("speeds_m_per_s"),
            speed -> speed > 0 && speed <= RunSettings.GREATEST_SPEED_M_PER_S,
            "a speed in (0, " + RunSettings.GREATEST_SPEED_M_PER_S + "] m/s"));
  }

  private static Pace pace(JsonInput root) throws DataFormatException {
    double turnRate = Tuning.TURN_RATE;
    if (root.has("turn_rate_rad_per_s")) {
      double least = Pace.LEAST_TURN_RATE_RAD_PER_S;
      turnRate =
          root.field("turn_rate_rad_per_s")
              .number(v -> v >= least && v <= Tuning.TURN_RATE, "in [" + least + ", 2 pi] rad/s");
    }
    double wait = 0;
    if (root.has("wait_s")) {
      wait =
          root.field("wait_s")
              .number(v -> v >= 0 && v <= Pace.MOST_WAIT_S, "in [0, " + Pace.MOST_WAIT_S + "] s");
    }
    return new Pace(turnRate, wait);
  }

  private static BatchChoices<Long> seeds(JsonInput value) throws DataFormatException {
    if (value.isList()) {
      return BatchChoices.of(SpecFields.wholes(value));
    }
    SpecFields.allowOnly(value, "from", "count");
    long from = value.field("from").whole();
    long count = SpecFields.count(value.field("count"));
    if (from > 0 && count - 1 > Long.MAX_VALUE - from) {
      throw value.field("count").fault("the last seed is beyond 64 bits");
    }
    return new BatchChoices<>(count, number -> from + number);
  }

  private static Sample sample(JsonInput value) throws DataFormatException {
    SpecFields.allowOnly(value, "runs", "seed");
    return new Sample(SpecFields.count(value.field("runs")), value.field("seed").whole());
  }

  /** A fault of the spec as a whole. */
  DataFormatException fault(String problem) {
    return DataFormatException.inFile(file, problem);
  }
}
