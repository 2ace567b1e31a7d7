package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BatchJobTest {
  private static final String GAIN =
      "[{\"effect\": \"gain\", \"form\": \"factor\", \"parameters\": {\"factor\": %s}}]";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static List<String> rows(BatchJob job) {
    return LongStream.range(0, job.size()).mapToObj(n -> job.piece(n).row()).toList();
  }

  private static String field(BatchJob job, String row, String column) {
    return row.strip().split(",", -1)[job.columns().names().indexOf(column)];
  }

  private static double number(BatchJob job, long run, String column) {
    return Double.parseDouble(field(job, job.piece(run).row(), column));
  }

  @Test
  void runs_countTheSeedFastest_andTheSensorSlowest() throws Exception {
    BatchJob job =
        Specs.job(
            folder,
            "\"sensors\": [\"noisy\", \"shadow\"], \"seeds\": [5, 3],"
                + "\"controllers\": [{\"name\": \"moody\", \"parameters\": {\"mood\": [0, 3]}}]");
    assertEquals(8, job.size());
    List<String> found =
        rows(job).stream()
            .map(
                row ->
                    field(job, row, "run")
                        + field(job, row, "sensor")
                        + field(job, row, "controller.mood")
                        + field(job, row, "seed"))
            .toList();
    assertEquals(
        List.of(
            "0noisy0.05",
            "1noisy0.03",
            "2noisy3.05",
            "3noisy3.03",
            "4shadow0.05",
            "5shadow0.03",
            "6shadow3.05",
            "7shadow3.03"),
        found);
  }

  /** The original sensor crosses every bearing far from an edge that it never keeps. */
  @Test
  void edge_isKeptByTheShadowAlone() throws Exception {
    BatchJob job = Specs.job(folder, "\"sensors\": [\"shadow\", \"original\"]");
    assertTrue(number(job, 0, "edge_kept") > 0.95);
    assertTrue(number(job, 0, "edge_to_trace_max_cm") < 5);
    assertEquals(0, number(job, 1, "edge_kept"));
    assertTrue(number(job, 1, "edge_to_trace_mean_cm") > 5);
    assertTrue(number(job, 1, "edge_to_trace_mean_cm") < number(job, 1, "edge_to_trace_max_cm"));
  }

  @Test
  void noise_isTheSeeds() throws Exception {
    BatchJob job = Specs.job(folder, "\"sensors\": [\"noisy\"], \"seeds\": [1, 2]");
    assertNotEquals(number(job, 0, "mean_abs_cm"), number(job, 1, "mean_abs_cm"));
    assertEquals(job.piece(0), job.piece(0));
  }

  @Test
  void sample_takesDifferentRunsOfTheProduct() throws Exception {
    BatchJob job =
        Specs.job(
            folder,
            "\"sensors\": [\"shadow\"], \"seeds\": {\"from\": -2, \"count\": 1000000000000},"
                + "\"sample\": {\"runs\": 20, \"seed\": 4}");
    Set<String> seeds =
        rows(job).stream().map(row -> field(job, row, "seed")).collect(Collectors.toSet());
    assertEquals(20, job.size());
    assertEquals(20, seeds.size());
    assertTrue(seeds.stream().anyMatch(seed -> Long.parseLong(seed) > 1000000), "" + seeds);
  }

  @Test
  void failure_isARowOfOneLine() throws Exception {
    BatchJob job =
        Specs.job(
            folder,
            "\"sensors\": [\"shadow\"],"
                + "\"controllers\": [{\"name\": \"moody\", \"parameters\": {\"mood\": [0, 1, 2]}}]");
    assertFalse(job.piece(0).failed());
    assertTrue(job.piece(1).failed());
    assertTrue(
        job.piece(1).row().contains("IllegalArgumentException: mood = 1 does not go with anything"),
        job.piece(1).row());
    assertTrue(job.piece(2).row().contains("in a bad mood, \"\"today\"\""), job.piece(2).row());
    rows(job).forEach(row -> assertEquals(row.length() - 1, row.indexOf('\n')));
  }

  /** Another machine gets the bytes and nothing else; the files may be gone by then. */
  @Test
  void job_isWholeByItself() throws Exception {
    BatchJob job = Specs.job(folder, "\"sensors\": [\"noisy\"], \"traces\": true");
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(job);
    }
    Files.delete(folder.resolve("small.csv"));
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      BatchJob sent = (BatchJob) in.readObject();
      assertEquals(job.piece(0), sent.piece(0));
      assertTrue(sent.piece(0).trace().lines().count() > 100);
    }
  }

  /** A late robot that is given its time goes the same way round; its file is copied. */
  @Test
  void robots_areADimension_andAreGivenTime() throws Exception {
    Path late = folder.resolve("late.json");
    Files.writeString(
        late, "{\"format\": \"motion-gap/1\", \"kinematics\": \"unicycle\", \"latency_s\": 0.2}");
    BatchJob job =
        Specs.job(
            folder,
            "\"sensors\": [\"shadow\"], \"robots\": [\"told\", \"late.json\"],"
                + "\"turn_rate_rad_per_s\": 1, \"wait_s\": 0.25, \"seeds\": [1]");
    Files.delete(late);
    assertEquals(
        List.of("shadow", "shadow-on-late"),
        rows(job).stream().map(row -> field(job, row, "sensor")).toList());
    assertEquals(number(job, 0, "way_m"), number(job, 1, "way_m"), 0.02);
    assertEquals(1, number(job, 1, "edge_kept"), 0.05);
    assertTrue(job.inputs().containsKey("robots/2/late.json"), job.inputs().keySet().toString());
    BatchJob hasty = Specs.job(folder, "\"sensors\": [\"shadow\"], \"seeds\": [1]");
    assertTrue(number(hasty, 0, "simulated_s") < number(job, 0, "simulated_s") / 3);
  }

  /** A gain of 1 changes nothing, one of 0.5 halves the thresholds: the way round too. */
  @Test
  void effects_actOnTheShadowSensor() throws Exception {
    BatchJob job =
        Specs.job(
            folder,
            "\"sensors\": [\"shadow\"], \"effects\": [[], "
                + GAIN.formatted(1)
                + ","
                + GAIN.formatted(0.5)
                + "]");
    assertEquals("", field(job, job.piece(0).row(), "effects"));
    assertEquals("gain/factor(factor=0.5)", field(job, job.piece(2).row(), "effects"));
    assertEquals(number(job, 0, "mean_abs_cm"), number(job, 1, "mean_abs_cm"));
    assertEquals(12.5, number(job, 2, "mean_abs_cm"), 1.5);
  }

  private static String obstacle(String name, double xM, double zM, double turnDeg) {
    return ("{\"name\": \"%s\", \"x_m\": %s, \"z_m\": %s, \"turn_deg\": %s, \"detection\": \"uniform\","
            + " \"uniform_range_m\": 0.3, \"outline_m\": [[0.01, 0], [0, 0.01], [-0.01, 0], [0, -0.01]]}")
        .formatted(name, xM, zM, turnDeg);
  }

  private String scene(String name, String... obstacles) throws Exception {
    Files.writeString(
        folder.resolve(name),
        """
        {"format": "sonar-gap/1", "no_echo_m": 6.5,
         "sensor": {
          "name": "by hand", "cone_half_angle_deg": 27.5, "min_range_m": 0.03, "max_range_m": 6,
          "mount_height_m": 0.05, "assumed_sound_speed_m_s": 343, "resolution_m": 0.01,
          "range_noise_m": 0, "miss_rate": 0, "edge_width_m": 0, "update_period_s": 0.05},
         "obstacles": [%s]}
        """
            .formatted(String.join(",", obstacles)));
    return "\"" + name + "\"";
  }

  /**
   * The first stands at the origin wherever the scene has it. A second one whose circle of 30 cm
   * lies half-way over the first's makes a longer way round both: 2 pi r (1 + 1/3) against 2 pi r.
   */
  @Test
  void scene_isCircledRoundItsFirstObstacle() throws Exception {
    String scenes =
        String.join(
            ",",
            scene("alone.json", obstacle("a", 0, 0, 0)),
            scene("moved.json", obstacle("a", 3, -2, 90)),
            scene("two.json", obstacle("a", 1, 1, 90), obstacle("b", 1, 1.3, 0)));
    Files.writeString(
        folder.resolve("scenes.json"),
        "{\"format\": \"simbad-batch/1\", \"sensors\": [\"shadow\"], \"speeds_m_per_s\": [0.1],"
            + "\"scenes\": ["
            + scenes
            + "]}");
    Path spec = folder.resolve("scenes.json");
    BatchJob job = BatchJob.read(spec, Files.readString(spec));
    assertEquals("alone.json", field(job, job.piece(0).row(), "scene"));
    assertEquals("a", field(job, job.piece(2).row(), "obstacle"));
    assertEquals(0, number(job, 0, "mean_abs_cm"), 1);
    assertEquals(number(job, 0, "way_m"), number(job, 1, "way_m"), 0.1);
    assertEquals(4 / 3.0, number(job, 2, "way_m") / number(job, 0, "way_m"), 0.15);
  }
}
