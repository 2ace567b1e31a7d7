package simbad.blindworld.generate;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.Decimals;
import simbad.blindworld.file.Json;
import simbad.blindworld.file.Output;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;

/** Writes a case: the data set to one tree, what is sealed to another. */
final class CaseFiles {

  /** The same for every file, so that no time tells anything. */
  private static final FileTime TIME = FileTime.fromMillis(1_577_836_800_000L);

  private static final int SALT_BYTES = 32;

  private final Path directory;

  CaseFiles(Path directory) {
    this.directory = directory;
  }

  /**
   * What is written of a case.
   *
   * @param assignment what was asked
   * @param scene what the simulator believes
   * @param readings the rows of the data set
   * @param reference rows of the same set-up without the effects, where there are any
   * @param sealed fresh rows of the same world
   * @param oracle the world's own forecast of them
   * @param truth what is sealed, less the hashes of the files beside it
   */
  record Content(
      Plan.Assignment assignment,
      Scene scene,
      Case.Sheet readings,
      Optional<Case.Sheet> reference,
      Case.Sheet sealed,
      Forecast oracle,
      Map<String, Object> truth) {}

  /** What the manifest says of a case. */
  Map<String, Object> write(Content drawn) throws IOException {
    String id = drawn.assignment().id();
    Path open = Files.createDirectories(directory.resolve("cases").resolve(id));
    Path sealed = Files.createDirectories(directory.resolve("truth").resolve(id));
    Map<String, Object> files = new LinkedHashMap<>();
    files.put("scene.json", put(open, "scene.json", Json.write(scene(drawn.scene()))));
    files.put("readings.csv", put(open, "readings.csv", sheet(drawn.readings(), true)));
    if (drawn.reference().isPresent()) {
      files.put("reference.csv", put(open, "reference.csv", sheet(drawn.reference().get(), true)));
    }
    Map<String, Object> truth = new LinkedHashMap<>(drawn.truth());
    truth.put("sealed_sha256", put(sealed, "sealed.csv", sheet(drawn.sealed(), true)));
    truth.put("oracle_sha256", put(sealed, "oracle.csv", drawn.oracle().csv()));
    String commitment = commit(sealed, truth, drawn.assignment().seed());
    Files.setLastModifiedTime(open, TIME);
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("case", id);
    entry.put("files", files);
    Path rows = Files.createDirectories(directory.resolve("rows").resolve(id));
    entry.put("rows_sha256", put(rows, "rows.csv", sheet(drawn.sealed(), false)));
    entry.put("commitment", commitment);
    return entry;
  }

  /** Writes truth and salt, and returns what binds both. */
  private static String commit(Path sealed, Map<String, Object> truth, long seed)
      throws IOException {
    String text = Json.write(truth);
    put(sealed, "truth.json", text);
    byte[] salt = salt(seed);
    put(sealed, "salt.txt", Seal.hex(salt) + "\n");
    return Seal.commitment(salt, text.getBytes(StandardCharsets.UTF_8));
  }

  /** What the manifest says of a case of motion. */
  Map<String, Object> write(MotionCase drawn) throws IOException {
    String id = drawn.assignment().id();
    Path open = Files.createDirectories(directory.resolve("cases").resolve(id));
    Path sealed = Files.createDirectories(directory.resolve("truth").resolve(id));
    Path rows = Files.createDirectories(directory.resolve("rows").resolve(id));
    Map<String, Object> truth = new LinkedHashMap<>(drawn.truth());
    truth.put("sealed_files", putAll(sealed, drawn.sealedFiles()));
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("case", id);
    entry.put("files", putAll(open, drawn.openFiles()));
    entry.put("rows", putAll(rows, drawn.rowFiles()));
    entry.put("commitment", commit(sealed, truth, drawn.assignment().seed()));
    Files.setLastModifiedTime(open, TIME);
    return entry;
  }

  private static Map<String, Object> putAll(Path folder, Map<String, String> texts)
      throws IOException {
    Map<String, Object> hashes = new LinkedHashMap<>();
    for (Map.Entry<String, String> text : texts.entrySet()) {
      hashes.put(text.getKey(), put(folder, text.getKey(), text.getValue()));
    }
    return hashes;
  }

  /** Writes a text file and returns its SHA-256. */
  static String put(Path folder, String name, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    Path file = Output.write(folder.resolve(name), text);
    Files.setLastModifiedTime(file, TIME);
    return Seal.sha256(bytes);
  }

  static byte[] salt(long seed) {
    byte[] salt = new byte[SALT_BYTES];
    new Chance(seed ^ 0x5EA1L).nextBytes(salt);
    return salt;
  }

  private static Map<String, Object> scene(Scene scene) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("format", "sonar-gap/1");
    json.put("no_echo_m", scene.noEchoM());
    json.put("sensor", sensor(scene.sensor()));
    List<Object> obstacles = new ArrayList<>();
    for (Obstacle obstacle : scene.obstacles()) {
      obstacles.add(obstacle(obstacle));
    }
    json.put("obstacles", obstacles);
    return json;
  }

  private static Map<String, Object> sensor(Sensor sensor) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("name", sensor.name());
    json.put("cone_half_angle_deg", Math.toDegrees(sensor.halfAngleRad()));
    json.put("min_range_m", sensor.minRangeM());
    json.put("max_range_m", sensor.maxRangeM());
    json.put("mount_height_m", sensor.mountHeightM());
    json.put("assumed_sound_speed_m_s", sensor.soundSpeedMPerS());
    json.put("resolution_m", sensor.resolutionM());
    json.put("range_noise_m", sensor.rangeNoiseM());
    json.put("miss_rate", sensor.missRate());
    json.put("edge_width_m", sensor.edgeWidthM());
    json.put("update_period_s", sensor.periodS());
    return json;
  }

  private static Map<String, Object> obstacle(Obstacle obstacle) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("name", obstacle.name());
    json.put("x_m", obstacle.place().xM());
    json.put("z_m", obstacle.place().zM());
    json.put("turn_deg", Math.toDegrees(obstacle.turnRad()));
    json.put("outline_m", obstacle.outline().stream().map(p -> List.of(p.xM(), p.zM())).toList());
    boolean uniform = obstacle.shadow().isUniform();
    json.put("detection", uniform ? "uniform" : "table");
    if (uniform) {
      json.put("uniform_range_m", obstacle.shadow().atM(0));
    } else {
      json.put("thresholds_m", obstacle.shadow().radiiM());
    }
    return json;
  }

  /** Rows as a file has them. */
  static String sheet(Case.Sheet sheet, boolean withRanges) {
    StringBuilder text = new StringBuilder("run,sensor,t_s,x_m,z_m,heading_deg");
    text.append(withRanges ? ",range_m\n" : "\n");
    List<Row> rows = sheet.recording().rows();
    for (int i = 0; i < rows.size(); i++) {
      Row row = rows.get(i);
      text.append(row.run()).append(',').append(row.sensor()).append(',');
      Decimals.append(text, row.tS(), 3).append(',');
      Decimals.append(text, row.pose().xM(), 4).append(',');
      Decimals.append(text, row.pose().zM(), 4).append(',');
      Decimals.append(text, Math.toDegrees(row.pose().headingRad()), 3);
      double range = sheet.rangesM().get(i);
      text.append(withRanges ? "," : "");
      if (withRanges && range < Double.POSITIVE_INFINITY) {
        Decimals.append(text, range, 4);
      }
      text.append('\n');
    }
    return text.toString();
  }
}
