package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Recordings that rosbags and mcap wrote (data/logs/bags/make.py), and broken ones. */
class DatasetBagCommandTest {
  private static final Path BAGS = Path.of("..", "data", "logs", "bags");
  private static final String TARGET = "round:50mm@1.5,0.4";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static Shell bag(Path recording, String... words) {
    List<String> all = new ArrayList<>(List.of("dataset", "bag", recording.toString()));
    all.addAll(List.of(words));
    return Shell.simbad(all.toArray(String[]::new));
  }

  private List<ReadingRow> rows(String name) throws DataFormatException {
    Path out = folder.resolve("out-" + name);
    Shell shell = bag(BAGS.resolve(name), "--target", TARGET, "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    return ReadingsFile.read(out.resolve("readings.csv"));
  }

  @Test
  void whatWasUnderstood_isDrawn() throws Exception {
    Path out = folder.resolve("drawn");
    Path picture = folder.resolve("drawn.svg");
    Shell shell =
        bag(
            BAGS.resolve("post"),
            "--target",
            TARGET,
            "--out",
            out.toString(),
            "--picture",
            picture.toString());
    assertEquals(0, shell.status(), shell.err());
    String svg = Files.readString(picture);
    assertTrue(svg.contains("Sensors and echoes in drawn"), svg);
    assertEquals(2, bag(BAGS.resolve("post"), "--out", "x", "--picture", "x.doc").status());
  }

  /** 50 pings of each of two sonars, of which one time is no number. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "post-mcap",
        "post-message-zstd",
        "post-file-zstd",
        "post-plain.mcap",
        "post-lz4.mcap",
        "post-zstd.mcap"
      })
  void everyForm_isTheSameRecording(String name) throws DataFormatException {
    List<ReadingRow> expected = rows("post");
    List<ReadingRow> found = rows(name);
    assertEquals(98, found.size());
    for (int i = 0; i < found.size(); i++) {
      assertEquals(expected.get(i).pose(), found.get(i).pose());
      assertEquals(expected.get(i).timeS(), found.get(i).timeS());
      assertEquals(expected.get(i).sensor(), found.get(i).sensor());
      assertEquals(expected.get(i).reading(), found.get(i).reading());
    }
  }

  /** Frames are joined rightly if ranges are the way from the sonar to the post's surface. */
  @Test
  void echoes_areAsFarAsThePost() throws DataFormatException {
    int echoes = 0;
    for (ReadingRow row : rows("post")) {
      double x = 1.5 - row.pose().position().xM();
      double z = 0.4 - row.pose().position().zM();
      double off = Math.atan2(-z, x) - row.pose().heading().radians();
      boolean inCone = Math.abs(Math.IEEEremainder(off, 2 * Math.PI)) < Math.toRadians(27.5);
      double distance = Math.hypot(x, z) - 0.025;
      if (row.reading() instanceof Echo echo) {
        assertEquals(distance, echo.rangeM(), 4 * 0.003, row.toString());
        assertTrue(inCone, row.toString());
        echoes++;
      } else {
        assertFalse(inCone && distance < 1.2, row.toString());
      }
    }
    assertTrue(echoes > 5, echoes + " echoes");
  }

  @Test
  void scene_hasWhatTheMessagesSay() throws DataFormatException {
    rows("post");
    SensingSetup setup = SceneFile.read(folder.resolve("out-post/scene.json"));
    assertEquals(4, setup.sensor().maxRangeM(), 1e-6);
    assertEquals(0.03, setup.sensor().minRangeM(), 1e-6);
    assertEquals(27.5, Math.toDegrees(setup.sensor().coneHalfAngleRad()), 1e-3);
    assertEquals(0.15, setup.sensor().mountHeightM(), 1e-6);
  }

  /** What is said counts more, and one sensor can be taken alone. */
  @Test
  void options_sayMore() throws DataFormatException {
    Path out = folder.resolve("one");
    Shell shell =
        bag(
            BAGS.resolve("post"),
            "--topic",
            "/sonar_right",
            "--max-range",
            "3m",
            "--target",
            TARGET,
            "--out",
            out.toString());
    assertEquals(0, shell.status(), shell.err());
    List<ReadingRow> rows = ReadingsFile.read(out.resolve("readings.csv"));
    assertTrue(rows.stream().allMatch(row -> row.sensor().equals("sonar_right")));
    assertEquals(49, rows.size());
    assertEquals(3, SceneFile.read(out.resolve("scene.json")).sensor().maxRangeM());
    assertTrue(shell.out().contains("again: ./simbad dataset bag "), shell.out());
    assertTrue(shell.out().contains("--topic /sonar_right"), shell.out());
  }

  /** What is written can be read: the same but for ranges of 32 bits and names. */
  @ParameterizedTest
  @ValueSource(strings = {"angle-against-uniform", "hankb", "apple190"})
  void exported_comesBack(String name) throws DataFormatException {
    Path set = Path.of("..", "data", "gap", name);
    Path recording = folder.resolve(name);
    Shell export = Shell.simbad("export", "bag", set.toString(), "--out", recording.toString());
    assertEquals(0, export.status(), export.err());
    Path out = folder.resolve("back");
    Shell shell =
        bag(recording, "--scene", set.resolve("scene.json").toString(), "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    List<ReadingRow> before = ReadingsFile.read(set.resolve("readings.csv"));
    List<ReadingRow> after = ReadingsFile.read(out.resolve("readings.csv"));
    assertEquals(before.size(), after.size());
    List<String> expected = before.stream().map(DatasetBagCommandTest::line).sorted().toList();
    assertEquals(expected, after.stream().map(DatasetBagCommandTest::line).sorted().toList());
  }

  private Path run(String name, String... words) {
    Path out = folder.resolve(name);
    List<String> all =
        new ArrayList<>(List.of("run", "round", "--speed", "0.5", "--out", out.toString()));
    all.addAll(List.of(words));
    assertDone(Shell.simbad(all.toArray(String[]::new)));
    return out;
  }

  private Shell exported(Path from) {
    return Shell.simbad("export", "bag", from.toString(), "--out", folder.resolve("b").toString());
  }

  /** The twelve sonars of the robot, as they read while it drove. */
  @Test
  void runWithReadings_becomesARecording() throws DataFormatException {
    Path run = run("run", "--sensor", "shadow", "--readings");
    assertDone(exported(run));
    Shell listed = bag(folder.resolve("b"), "--list");
    assertTrue(listed.out().contains("frame sonar_11 in map ("), listed.out());
    Path out = folder.resolve("back");
    assertDone(bag(folder.resolve("b"), "--target", "round:25mm", "--out", out.toString()));
    List<ReadingRow> read = ReadingsFile.read(run.resolve("round/readings-shadow/readings.csv"));
    assertEquals(read.size(), ReadingsFile.read(out.resolve("readings.csv")).size());
    assertTrue(read.stream().anyMatch(row -> row.reading() instanceof Echo));
  }

  @Test
  void runWithoutReadings_orWithSeveral_isRefusedInALine() {
    Shell none = exported(run("none", "--sensor", "shadow"));
    assertEquals(2, none.status());
    assertTrue(none.err().contains("expected one of simbad run --readings"), none.err());
    Shell several = exported(run("several", "--readings"));
    assertEquals(2, several.status());
    assertTrue(several.err().contains("several/round/readings-original, "), several.err());
    assertEquals(1, several.err().lines().count(), several.err());
  }

  /** To a millimetre and a hundredth of a degree. */
  private static String line(ReadingRow row) {
    return String.format(
        Locale.ROOT,
        "%.3f %.3f %.2f %s",
        row.pose().position().xM() + 1e-9,
        row.pose().position().zM() + 1e-9,
        Math.toDegrees(row.pose().heading().radians()) + 1e-9,
        row.reading() instanceof Echo echo
            ? String.format(Locale.ROOT, "%.3f", echo.rangeM())
            : "");
  }

  /** Whoever has both diagnoses either: but for the hashes of the files nothing differs. */
  @Test
  void sameLog_asTableAndAsRecording_hasTheSameDiagnosis() throws IOException {
    Path known = Path.of("../data/gap/angle-against-uniform");
    Path log = Files.createDirectories(folder.resolve("log"));
    Path scene = Files.copy(known.resolve("scene.json"), log.resolve("scene.json"));
    Path table = log.resolve("readings.csv");
    Files.write(table, Files.readAllLines(known.resolve("readings.csv")).subList(0, 301));
    Path recording = folder.resolve("recording");
    assertDone(Shell.simbad("export", "bag", log.toString(), "--out", recording.toString()));
    String columns =
        "--run run --time t_s --sensor sensor --x x_m --z z_m --heading heading_deg --range range_m"
            + " --time-unit s --pose-unit m --angle-unit deg --range-unit m --scene "
            + scene;
    String asTable = diagnosis("csv", table, columns.split(" ", -1));
    assertTrue(asTable.contains("orientation-shadow"), asTable);
    assertEquals(asTable, diagnosis("bag", recording, "--scene", scene.toString()));
  }

  private String diagnosis(String kind, Path from, String... options) throws IOException {
    Path made = Files.createDirectories(folder.resolve(kind)).resolve("log");
    List<String> words = new ArrayList<>(List.of("dataset", kind, from.toString()));
    words.addAll(List.of(options));
    words.addAll(List.of("--out", made.toString()));
    assertDone(Shell.simbad(words.toArray(String[]::new)));
    Path out = folder.resolve(kind).resolve("diagnoses");
    assertDone(Shell.simbad("diagnose", made.toString(), "--out", out.toString()));
    return Files.readString(out.resolve("log/diagnosis.json"))
        .replaceAll("\"[0-9a-f]{64}\"", "a hash");
  }

  private static void assertDone(Shell shell) {
    assertEquals(0, shell.status(), shell.err());
  }

  @Test
  void contents_areListed() {
    Shell shell = bag(BAGS.resolve("post"), "--list");
    assertEquals(0, shell.status(), shell.err());
    assertEquals(
        List.of(
            "/sonar_front: 50 of sensor_msgs/msg/Range",
            "/sonar_right: 50 of sensor_msgs/msg/Range",
            "/tf: 151 of tf2_msgs/msg/TFMessage",
            "/tf_static: 1 of tf2_msgs/msg/TFMessage",
            "frame base_link in odom (151 poses)",
            "frame sonar_front in base_link (fixed)",
            "frame sonar_right in base_link (fixed)"),
        shell.out().lines().toList());
  }

  @ParameterizedTest
  @CsvSource({
    "post, --topic, /radar, '--topic: ''/radar'' is not one of /sonar_front, /sonar_right'",
    "post, --fixed-frame, mars, --fixed-frame",
    "make.py, --sonar, srf04, is neither MCAP nor SQLite",
    "none, --sonar, srf04, is neither a file nor a folder"
  })
  void whatIsWrong_isSaidInALine(String name, String option, String value, String said) {
    Shell shell =
        bag(BAGS.resolve(name), option, value, "--out", folder.resolve("wrong").toString());
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains(said), shell.err());
    assertEquals(1, shell.err().lines().count(), shell.err());
    assertFalse(Files.exists(folder.resolve("wrong")));
  }

  @Test
  void eitherOutOrList() {
    assertEquals(2, bag(BAGS.resolve("post")).status());
    assertEquals(2, bag(BAGS.resolve("post"), "--list", "--out", "x").status());
  }

  /** In turns it is listed, and made a data set or a motion folder of. */
  private Shell readIn(Path broken, int turn) throws IOException {
    try (TemporaryFolder work = TemporaryFolder.in(folder, "made")) {
      Path made = work.path().resolve("made");
      Shell shell =
          switch (turn % 3) {
            case 0 -> bag(broken, "--list");
            case 1 -> bag(broken, "--target", TARGET, "--out", made.toString());
            default ->
                Shell.simbad(
                    "dataset", "motion", "bag", broken.toString(), "--out", made.toString());
          };
      assertTrue(shell.status() == 0 || !Files.exists(made), shell.err());
      return shell;
    }
  }

  private void checkBroken(String name, int mutations, long seed) throws IOException {
    byte[] whole = Files.readAllBytes(BAGS.resolve(name));
    Path broken = folder.resolve("broken");
    Random random = new Random(seed);
    for (int i = 0; i < mutations; i++) {
      byte[] bytes = whole.clone();
      for (int k = random.nextInt(1, 6); k > 0; k--) {
        // Every other one is at an end of what a byte can be: numbers become huge, or none.
        int[] ends = {0, 0x7f, 0x80, 0xff};
        int value = random.nextBoolean() ? ends[random.nextInt(ends.length)] : random.nextInt();
        bytes[random.nextInt(bytes.length)] = (byte) value;
      }
      boolean cut = random.nextInt(4) == 0;
      int length = cut ? random.nextInt(bytes.length) : bytes.length;
      Files.write(broken, Arrays.copyOf(bytes, length));
      Shell shell = readIn(broken, i);
      String told = name + ", mutation " + i + ": " + shell.err();
      assertTrue(shell.status() == 0 || shell.status() == 2, told);
      assertFalse(shell.err().contains("a fault in the program"), told);
      long complaints = shell.err().lines().filter(line -> !line.startsWith("note: ")).count();
      assertEquals(shell.status() == 0 ? 0 : 1, complaints, told);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"post/post.db3", "post-plain.mcap", "post-lz4.mcap", "post-zstd.mcap"})
  void brokenFiles_areRefusedInALine(String name) throws IOException {
    checkBroken(name, 100, 11);
  }

  @Tag("full")
  @ParameterizedTest
  @ValueSource(
      strings = {
        "post/post.db3",
        "post-file-zstd/post-file-zstd.db3.zstd",
        "post-plain.mcap",
        "post-lz4.mcap",
        "post-zstd.mcap"
      })
  void brokenFiles_byTheThousand(String name) throws IOException {
    checkBroken(name, 20_000, 12);
  }
}
