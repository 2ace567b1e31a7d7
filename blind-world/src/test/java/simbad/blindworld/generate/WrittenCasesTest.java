package simbad.blindworld.generate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.baseline.DataSet;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Seal;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.MotionLog;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Track;
import simbad.blindworld.motion.Windows;
import simbad.blindworld.score.Truths;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.Shadow;

/** Cases as they are written, to the byte, and what binds them. */
class WrittenCasesTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final Sensor SENSOR =
      new Sensor("SRF04", Math.toRadians(18), 0.03, 4, 0.15, 343, 0.01, 0.004, 0.02, 0.03, 0.1);
  private static final List<Point> OUTLINE =
      List.of(new Point(0, 0), new Point(0.1, 0), new Point(0, 0.2));

  private static Scene scene() {
    return new Scene(
        4.5,
        SENSOR,
        List.of(
            new Obstacle("a", new Point(1, -2), 0.5, OUTLINE, new Shadow(List.of(1.0, 2.0, 1.5))),
            new Obstacle("b", new Point(0, 0), 0, OUTLINE, Shadow.uniform(2.5))));
  }

  private static Case.Sheet sheet(double... ranges) {
    List<Row> rows = new java.util.ArrayList<>();
    for (int i = 0; i < ranges.length; i++) {
      rows.add(new Row("r", "s", 0.5 * i, new Pose(-1.25, 0.5 * i, Math.PI / 2)));
    }
    return new Case.Sheet(new Recording(rows), java.util.Arrays.stream(ranges).boxed().toList());
  }

  private static Forecast forecast(int rows) {
    double[][] quantiles = new double[rows][Forecast.LEVELS];
    for (double[] row : quantiles) {
      java.util.Arrays.fill(row, 1);
    }
    return new Forecast(quantiles);
  }

  private static Case drawn(boolean reference, Optional<Case.Shown> shown, String... effects) {
    return new Case(
        new Plan.Assignment("c0000001", Kind.SINGLE, List.of(effects), reference, 9),
        "bench",
        scene(),
        Setup.nominal(SENSOR),
        java.util.Arrays.stream(effects)
            .map(name -> new Effect(name, Map.of("db", 3.0), new Change() {}))
            .toList(),
        sheet(1.25, NONE, 2),
        reference ? Optional.of(sheet(3)) : Optional.empty(),
        sheet(1.5, NONE),
        forecast(2),
        new Case.Gaps(7, 2, 1),
        shown,
        3);
  }

  @Test
  void case_isWrittenToThreeTrees(@TempDir Path folder) throws IOException, FormatException {
    Map<String, Object> entry =
        new CaseFiles(folder).write(drawn(true, Optional.empty(), "gain").content());
    assertEquals("c0000001", entry.get("case"));
    Path open = folder.resolve("cases/c0000001");
    assertEquals(
        """
        run,sensor,t_s,x_m,z_m,heading_deg,range_m
        r,s,0.000,-1.2500,0.0000,90.000,1.2500
        r,s,0.500,-1.2500,0.5000,90.000,
        r,s,1.000,-1.2500,1.0000,90.000,2.0000
        """,
        Files.readString(open.resolve("readings.csv")));
    assertEquals(
        """
        run,sensor,t_s,x_m,z_m,heading_deg
        r,s,0.000,-1.2500,0.0000,90.000
        r,s,0.500,-1.2500,0.5000,90.000
        """,
        Files.readString(folder.resolve("rows/c0000001/rows.csv")));
    assertTrue(Files.exists(open.resolve("reference.csv")));
    Scene read = DataSet.scene(open.resolve("scene.json"));
    assertEquals(4.5, read.noEchoM());
    assertEquals("SRF04", read.sensor().name());
    assertEquals(Math.toRadians(18), read.sensor().halfAngleRad(), 1e-9);
    assertEquals(0.03, read.sensor().edgeWidthM(), 1e-9);
    assertEquals(0.1, read.sensor().periodS(), 1e-9);
    assertEquals(0.5, read.obstacles().get(0).turnRad(), 1e-9);
    assertEquals(List.of(1.0, 2.0, 1.5), read.obstacles().get(0).shadow().radiiM());
    assertEquals(OUTLINE, read.obstacles().get(1).outline());
    assertEquals(List.of(2.5), read.obstacles().get(1).shadow().radiiM());
    Map<String, Object> manifest = Generator.manifest(List.of(entry));
    assertEquals(entry.get("commitment"), manifest.get("root"), "of one leaf");
    Generator.write(folder, manifest);
    Truths truths = new Truths(folder.resolve("truth"), Set.of());
    assertEquals(1, truths.verify(folder.resolve("manifest.json")));
    assertTrue(truths.read().get(0).reference());
    assertEquals(List.of(1.5, 4.5), truths.read().get(0).countedM());
  }

  @Test
  void truth_saysWhatWasDrawn(@TempDir Path folder) throws IOException, FormatException {
    Optional<Case.Shown> shown = Optional.of(new Case.Shown(List.of(1.5, 2.5), 6));
    new CaseFiles(folder).write(drawn(false, shown, "gain", "wind-shear").content());
    assertFalse(Files.exists(folder.resolve("cases/c0000001/reference.csv")));
    JsonObject truth = JsonObject.read(folder.resolve("truth/c0000001/truth.json"));
    assertEquals("single", truth.text("kind"));
    assertEquals(3, truth.object("effects").object("gain").number("db"));
    assertEquals(List.of("wind-shear"), truth.texts("outside_vocabulary"));
    assertEquals("bench", truth.text("design"));
    assertEquals(3, truth.number("rows"));
    assertEquals(2 / 3.0, truth.number("echo_share"), 1e-9);
    assertEquals(3, truth.number("draws"));
    assertEquals(List.of(1.5, 2.5), truth.numbers("sizes"));
    assertEquals(6, truth.number("z"));
    assertEquals(7, truth.number("sealed_gap_nominal_cm"));
    assertEquals(2, truth.number("sealed_gap_setup_cm"));
    assertEquals(1, truth.number("sealed_gap_oracle_cm"));
  }

  /** 32 bytes of a case's own chance; all files have one time. */
  @Test
  void salt_isOfTheCase(@TempDir Path folder) throws IOException {
    assertEquals(32, CaseFiles.salt(1).length);
    assertArrayEquals(CaseFiles.salt(1), CaseFiles.salt(1));
    assertFalse(java.util.Arrays.equals(CaseFiles.salt(1), CaseFiles.salt(2)));
    String hash = CaseFiles.put(folder, "x", "abc");
    assertEquals(Seal.sha256("abc".getBytes(java.nio.charset.StandardCharsets.UTF_8)), hash);
    assertEquals(1_577_836_800_000L, Files.getLastModifiedTime(folder.resolve("x")).toMillis());
  }

  @Test
  void folder_hasToBeEmpty(@TempDir Path folder) throws IOException {
    Generator.requireEmpty(folder.resolve("new/deep"));
    assertTrue(Files.isDirectory(folder.resolve("new/deep")));
    Generator.requireEmpty(folder.resolve("new/deep"));
    assertThrows(IOException.class, () -> Generator.requireEmpty(folder.resolve("new")));
  }

  private static Outing outing() {
    Commands told =
        new Commands(new double[] {0, 1.5}, new double[] {0.3, 0}, new double[] {0.8, -0.5});
    return new Outing(
        List.of(new Outing.Run("r", told, new double[] {0, 0.5}, 0.5, new Pose(0, 0, 0))));
  }

  private static Robot robot(boolean differential, Robot.Beliefs beliefs, double sigmaM) {
    return new Robot(
        differential ? 0.03 : 0,
        differential ? 0.25 : 1,
        differential,
        beliefs,
        new Robot.Scatter(sigmaM, sigmaM),
        differential);
  }

  /** What is written of a robot and its log is read back. */
  @Test
  void robot_isReadBack(@TempDir Path folder) throws IOException, FormatException {
    Robot wheels = robot(true, new Robot.Beliefs(0.1, 0.2, 0.5, 2), 0.25);
    Robot plain = robot(false, Robot.Beliefs.NONE, 0);
    Path file = folder.resolve("robot.json");
    for (Robot robot : List.of(wheels, plain)) {
      Files.writeString(file, MotionFiles.robot(robot));
      Robot read = MotionLog.robot(file);
      assertEquals(robot.beliefs(), read.beliefs());
      assertEquals(robot.differential(), read.differential());
      assertEquals(robot.wheelBaseM(), read.wheelBaseM());
      assertEquals(robot.separateClocks(), read.separateClocks());
      assertEquals(robot.tracker().headingRad(), read.tracker().headingRad(), 1e-9);
    }
    assertFalse(MotionFiles.robot(plain).contains("latency"));
    assertFalse(MotionFiles.robot(plain).contains("time_constant"));
    assertFalse(MotionFiles.robot(plain).contains("max_"));
    assertFalse(MotionFiles.robot(plain).contains("track_"));
    assertFalse(MotionFiles.robot(plain).contains("clocks"));
    assertTrue(MotionFiles.robot(wheels).contains("turn_time_constant_s"));
  }

  /** 0.3 m/s and 0.8 rad/s on a base of 0.25 m are rims of 0.2 and 0.4 m/s. */
  @Test
  void log_isWrittenInItsDecimals() {
    assertEquals(
        "run,t_s,left_m_s,right_m_s\nr,0.000,0.20000,0.40000\nr,1.500,0.06250,-0.06250\n",
        MotionFiles.commands(robot(true, Robot.Beliefs.NONE, 0), outing()));
    assertEquals(
        "run,t_s,v_m_s,w_rad_s\nr,0.000,0.30000,0.80000\nr,1.500,0.00000,-0.50000\n",
        MotionFiles.commands(robot(false, Robot.Beliefs.NONE, 0), outing()));
    Track track = Track.of(List.<double[][]>of(new double[][] {{1, 2}, {-3, 4}, {3, 3.5}}));
    assertEquals(
        String.format(
            Locale.ROOT,
            """
        run,t_s,x_m,z_m,heading_deg
        r,0.0000,1.00000,-3.00000,%.3f
        r,0.5000,2.00000,4.00000,%.3f
        """,
            Math.toDegrees(3),
            Math.toDegrees(3.5) - 360),
        MotionFiles.track(outing(), track));
  }

  /**
   * Windows of half a second at 0 and at 10 s. The rival is 1 off in the first and 3 in the second,
   * 2 in the mean; the better one is right and then 3 off. So a block gains 1/2 and the other none:
   * 1/4, with a standard deviation of 1/4 over two blocks, of which one is free.
   */
  @Test
  void motionEvidence_isByTenSeconds() {
    Outing outing =
        new Outing(
            List.of(
                new Outing.Run(
                    "r",
                    new Commands(new double[0], new double[0], new double[0]),
                    new double[] {0, 0.5, 10, 10.5},
                    10.5,
                    new Pose(0, 0, 0))));
    Windows windows = Windows.of(outing);
    assertEquals(2, windows.size());
    double[][] shown = {{1, 1, 1}, {4, 4, 4}};
    MotionForecast rival = points(0, 1);
    MotionForecast better = points(1, 1);
    MotionEvidence.Gain gain = MotionEvidence.of(better, rival, windows, shown);
    assertEquals(0.25, gain.share(), 1e-12);
    assertEquals(1, gain.standardErrors(), 1e-9);
    assertEquals(0, MotionEvidence.of(rival, rival, windows, shown).standardErrors());
  }

  private static MotionForecast points(double first, double second) {
    double[][][] quantiles = new double[2][3][MotionForecast.LEVELS];
    for (int c = 0; c < 3; c++) {
      java.util.Arrays.fill(quantiles[0][c], first);
      java.util.Arrays.fill(quantiles[1][c], second);
    }
    return new MotionForecast(quantiles);
  }

  private static void foreign(Path set, boolean whole) throws IOException {
    Files.createDirectories(set);
    Files.writeString(set.resolve("scene.json"), "{\"no_echo_m\": 4}");
    Files.writeString(set.resolve("readings.csv"), "range_m\n1\n");
    Files.writeString(set.resolve("truth.json"), "{\"effects\": {\"gain\": {}}}");
    if (whole) {
      Files.writeString(
          set.resolve("sealed.csv"), "run,range_m,\"x,y\"\na,1,\"b \"\"c\"\"\"\nd,,e\n");
    }
  }

  @Test
  void foreignSets_areSealedAsTheyAre(@TempDir Path folder) throws IOException, FormatException {
    Path sets = folder.resolve("sets");
    foreign(sets.resolve("b"), true);
    foreign(sets.resolve("a"), true);
    ForeignSets foreign = ForeignSets.in(sets);
    assertEquals(
        List.of("a", "b"),
        foreign.folders().stream().map(f -> String.valueOf(f.getFileName())).toList());
    Path out = folder.resolve("out");
    foreign.seal(out, "L3", 7);
    assertEquals(
        "run,\"x,y\"\na,\"b \"\"c\"\"\"\nd,e\n", Files.readString(out.resolve("rows/a/rows.csv")));
    assertEquals("L3", JsonObject.read(out.resolve("manifest.json")).text("level"));
    Truths truths = new Truths(out.resolve("truth"), Set.of());
    assertEquals(2, truths.verify(out.resolve("manifest.json")));
    assertEquals(List.of(1.0, 4.0), truths.read().get(0).countedM());
    assertTrue(Files.notExists(out.resolve("cases/a/truth.json")));
    assertTrue(Files.notExists(out.resolve("cases/a/sealed.csv")));
    assertTrue(Files.exists(out.resolve("cases/a/scene.json")));
    foreign(sets.resolve("c"), false);
    assertThrows(FormatException.class, () -> ForeignSets.in(sets));
    assertThrows(FormatException.class, () -> ForeignSets.in(sets.resolve("none")));
    assertThrows(
        FormatException.class,
        () -> ForeignSets.in(Files.createDirectories(folder.resolve("empty"))));
  }
}
