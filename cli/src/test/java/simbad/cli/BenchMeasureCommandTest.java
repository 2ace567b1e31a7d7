package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BenchTarget;
import simbad.bench.board.Board;
import simbad.bench.board.BoardKit;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.TurntableBench;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** Readings at given poses, by the real program in gpsim at the other end of a real port. */
@Timeout(600)
class BenchMeasureCommandTest {
  private static final BoardKit KIT = BoardKit.ofProject(Path.of(".."));

  /** The board's clock is 1 us, the program's timer a few: less than a millimetre. */
  private static final double CLOCK_M = 0.002;

  @TempDir private Path folder = Path.of("target");

  private static void needTools() {
    assumeTrue(
        KIT.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + KIT.missingPackages());
  }

  private static List<ReadingRow> poses(int count) {
    Random random = new Random(3);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double bearing = random.nextDouble(0, 2 * Math.PI);
      double distance = random.nextDouble(0.1, 2.5);
      double heading = bearing + Math.PI / 2 + random.nextGaussian(0, 0.4);
      Pose pose = Pose.of(distance * Math.sin(bearing), distance * Math.cos(bearing), heading);
      rows.add(new ReadingRow("next-1", "left", 0.1 * i, pose, NoEcho.NO_ECHO));
    }
    return rows;
  }

  /** What the shadow sensor hears in the world's frame, where the obstacle stays and it moves. */
  private static double[] expected(List<ReadingRow> rows) {
    ObstacleType angle = Catalogue.find("angle").orElseThrow();
    Obstacle there =
        new Obstacle(
            "angle",
            new Placement(0, 0, 0),
            angle.outline(),
            new TableDetection(angle.thresholds().table()));
    Sensor sensor =
        DetectionRule.SHADOW.bind(Catalogue.srf04(), new Scene(List.of(there)), new Random(1));
    TransducerPoses at = new TransducerPoses(1);
    Readings reading = new Readings(1);
    double[] rangesM = new double[rows.size()];
    for (int i = 0; i < rangesM.length; i++) {
      Pose pose = rows.get(i).pose();
      double heading = pose.heading().radians();
      at.setPosition(0, pose.position().xM(), 0, pose.position().zM());
      at.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
      sensor.ping(at, 0, reading);
      rangesM[i] = reading.isEcho(0) ? reading.rangeM(0) : -1;
    }
    return rangesM;
  }

  /** Where all is read there is nothing to do: neither a port nor a board is asked for. */
  @Test
  void wholeFile_needsNoSensor() throws Exception {
    List<ReadingRow> rows = poses(4);
    Path file = Files.writeString(folder.resolve("poses.csv"), ReadingsWriter.posesText(rows));
    Path out = Files.writeString(folder.resolve("whole.csv"), ReadingsWriter.text(rows));
    String line = "bench measure " + file + " --out " + out + " --port " + folder.resolve("none");
    Shell done = Shell.simbad(line.split(" "));
    assertEquals(0, done.status(), done.err());
    assertEquals(ReadingsWriter.text(rows), Files.readString(out));
  }

  @Test
  void simulatedBoard_readsWhatTheWorldsSensorWould() throws Exception {
    needTools();
    List<ReadingRow> rows = poses(60);
    Path file = Files.writeString(folder.resolve("poses.csv"), ReadingsWriter.posesText(rows));
    Path out = folder.resolve("next.csv");
    Shell done =
        Shell.simbad(
            ("bench measure " + file + " --auto --obstacle angle --out " + out).split(" "));
    assertEquals(0, done.status(), done.err());
    double[] expected = expected(rows);
    List<ReadingRow> read = ReadingsFile.read(out);
    int echoes = 0;
    for (int i = 0; i < expected.length; i++) {
      double rangeM = read.get(i).reading() instanceof Echo echo ? echo.rangeM() : -1;
      assertEquals(expected[i], rangeM, CLOCK_M, "row " + (i + 1));
      assertEquals(rows.get(i).timeS(), read.get(i).timeS(), 1e-9);
      echoes += rangeM > 0 ? 1 : 0;
    }
    assertTrue(echoes > 5 && echoes < 55, echoes + " echoes");
  }

  /** Forty looks from one pose, the second half by a second command. */
  @Test
  void chance_doesNotBeginAgain_whenItGoesOn() throws Exception {
    needTools();
    ReadingRow look =
        new ReadingRow("next-1", "left", 0, Pose.of(0, 0.3, Math.PI / 2), NoEcho.NO_ECHO);
    Path out = folder.resolve("next.csv");
    for (int count : new int[] {20, 40}) {
      Path file = folder.resolve(count + ".csv");
      List<ReadingRow> rows = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        rows.add(new ReadingRow("next-1", "left", i, look.pose(), NoEcho.NO_ECHO));
      }
      Files.writeString(file, ReadingsWriter.posesText(rows));
      String command = " --auto --obstacle round --sensor noisy --out ";
      Shell done = Shell.simbad(("bench measure " + file + command + out).split(" "));
      assertEquals(0, done.status(), done.err());
    }
    List<ReadingRow> read = ReadingsFile.read(out);
    int alike = 0;
    for (int i = 0; i < 20; i++) {
      alike += read.get(i).reading().equals(read.get(20 + i).reading()) ? 1 : 0;
    }
    assertTrue(alike < 15, alike + " of 20 alike");
  }

  /** Ends where the person does, and goes on with the row that is missing. */
  @Test
  void person_isAskedForEachPlace() throws Exception {
    needTools();
    List<ReadingRow> rows = poses(3);
    Path file = Files.writeString(folder.resolve("poses.csv"), ReadingsWriter.posesText(rows));
    Path out = folder.resolve("next.csv");
    ObstacleType round = Catalogue.find("round").orElseThrow();
    BenchTarget target = new BenchTarget(round.outline(), round.thresholds().table());
    TurntableBench bench =
        new TurntableBench(
            DetectionRule.SHADOW,
            Catalogue.srf04(),
            new Random(1),
            new BenchScene(Optional.of(target), 0.5, 0, 0),
            20);
    try (Board board = Board.start(KIT, new BoardSetup(folder.resolve("tty"), 0), bench)) {
      String command = "bench measure " + file + " --port " + board.port() + " --out " + out;
      Shell ended = typed("\nq\n", command);
      assertEquals(1, ended.status(), ended.err());
      assertTrue(ended.err().contains("ended at row 2 of 3"), ended.err());
      assertTrue(ended.out().contains("1 of 3: sensor at x "), ended.out());
      Shell done = typed("\n\n", command);
      assertEquals(0, done.status(), done.err());
    }
    List<ReadingRow> read = ReadingsFile.read(out);
    assertEquals(List.of("next-1", "next-1 from row 2", "next-1 from row 2"), runs(read));
    for (ReadingRow row : read) {
      assertTrue(
          row.reading() instanceof Echo echo && Math.abs(echo.rangeM() - 0.4873) < CLOCK_M,
          row.reading().toString());
    }
  }

  private static List<String> runs(List<ReadingRow> rows) {
    return rows.stream().map(ReadingRow::run).toList();
  }

  private static Shell typed(String keys, String command) {
    InputStream before = System.in;
    try {
      System.setIn(new ByteArrayInputStream(keys.getBytes(StandardCharsets.UTF_8)));
      return Shell.simbad(command.split(" "));
    } finally {
      System.setIn(before);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "poses.csv --out x.csv | exactly one of --port and --auto",
        "poses.csv --auto --out x.csv | --obstacle goes with --auto",
        "nowhere.csv --auto --obstacle angle --out x.csv | nowhere.csv: no such file",
        "../README.md --auto --obstacle angle --out x.csv | README.md",
        "POSES --auto --obstacle angle --out ../README.md | README.md: does not begin with run",
        "POSES --auto --obstacle angle --out OTHER | row 2 does not have the pose",
        "POSES --auto --obstacle pots --out NEW | --obstacle: 'pots': no such obstacle",
        "POSES --auto --obstacle angle --temperature 99 --out NEW | --temperature: 99.0",
        "POSES --auto --obstacle angle --sensor ears --out NEW | --sensor: 'ears' is none"
      })
  void badInput_isOneLine(String arguments, String message) throws Exception {
    List<ReadingRow> rows = poses(3);
    Path poses = Files.writeString(folder.resolve("poses.csv"), ReadingsWriter.posesText(rows));
    List<ReadingRow> others = List.of(rows.get(0), rows.get(2));
    Path other = Files.writeString(folder.resolve("other.csv"), ReadingsWriter.text(others));
    String line =
        arguments
            .replace("POSES", poses.toString())
            .replace("OTHER", other.toString())
            .replace("NEW", folder.resolve("new.csv").toString());
    Shell shell = Shell.simbad(("bench measure " + line).split(" "));
    assertAll(
        () -> assertEquals(2, shell.status(), shell.err()),
        () -> assertEquals(1, shell.complaints().size(), shell.err()),
        () -> assertTrue(shell.err().contains(message), shell.err()),
        () -> assertEquals(ReadingsWriter.text(others), Files.readString(other)));
  }
}
