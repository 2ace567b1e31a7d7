package simbad.experiments.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.experiments.bag.RangeMessage.Meaning;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Recordings of rosbags and mcap, and frames and messages worked out on paper. */
class RecordingTest {
  private static final Path BAGS = Path.of("..", "data", "logs", "bags");
  private static final double QUARTER = Math.sqrt(0.5);

  private static BagTable table(String name) throws DataFormatException {
    return BagTable.of(Recording.read(BAGS.resolve(name)), Set.of(), Optional.empty());
  }

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
  void everyForm_isTheSameTable(String name) throws DataFormatException {
    assertEquals(table("post").text(), table(name).text());
    assertEquals(99, table(name).text().lines().count());
  }

  /** A quarter to the left at (1, 2), then 1 m ahead of it: at (1, 3), looking along y. */
  @Test
  void frames_areJoined() {
    Rigid turned = Rigid.of(1, 2, 0, 0, 0, QUARTER, QUARTER);
    Rigid there = turned.times(Rigid.of(1, 0, 0.1, 0, 0, 0, 1));
    assertEquals(1, there.xM(), 1e-12);
    assertEquals(3, there.yM(), 1e-12);
    assertEquals(0.1, there.zM(), 1e-12);
    assertEquals(Math.PI / 2, there.yawRad(), 1e-12);
  }

  /** Half-way between no turn and a quarter is an eighth, whichever sign the quaternion has. */
  @Test
  void between_isHalfWay() {
    for (int sign : new int[] {1, -1}) {
      Rigid to = Rigid.of(2, 0, 0, 0, 0, sign * QUARTER, sign * QUARTER);
      Rigid half = Rigid.NONE.towards(to, 0.5);
      assertEquals(1, half.xM(), 1e-12);
      assertEquals(Math.PI / 4, half.yawRad(), 1e-12);
    }
    assertEquals(0, Rigid.of(0, 0, 0, 0, 0, 0, 0).yawRad());
  }

  @Test
  void moments_areWithinATenthOfASecond() {
    Transforms tree = new Transforms();
    tree.moveByOdometry("odom", "base", 0, Rigid.of(9, 0, 0, 0, 0, 0, 1));
    tree.move("map", "base", 1_000_000_000L, Rigid.of(1, 0, 0, 0, 0, 0, 1));
    tree.move("map", "base", 2_000_000_000L, Rigid.of(2, 0, 0, 0, 0, 0, 1));
    tree.moveByOdometry("odom", "base", 3, Rigid.of(9, 0, 0, 0, 0, 0, 1));
    tree.fix("base", "sonar", Rigid.of(0.5, 0, 0, 0, 0, 0, 1));
    assertEquals(List.of("sonar", "base", "map"), tree.upwards("sonar"));
    assertEquals(1.75, tree.find("sonar", "map", 1_250_000_000L).orElseThrow().xM(), 1e-9);
    assertEquals(2.5, tree.find("sonar", "map", 2_090_000_000L).orElseThrow().xM(), 1e-9);
    assertTrue(tree.find("sonar", "map", 2_200_000_000L).isEmpty());
    assertTrue(tree.find("sonar", "odom", 1_250_000_000L).isEmpty());
    assertEquals(List.of("base in map (2 poses)", "sonar in base (fixed)"), tree.lines());
  }

  @ParameterizedTest
  @CsvSource({
    "1, ECHO",
    "0.01, TOO_NEAR",
    "-Infinity, TOO_NEAR",
    "4.5, NOTHING",
    "Infinity, NOTHING",
    "NaN, INVALID"
  })
  void ranges_meanWhatRep117Says(float range, Meaning meaning) {
    assertEquals(meaning, new RangeMessage("t", "f", 0, 0.5f, 0.03f, 4f, range).meaning());
  }

  @Test
  void message_isReadAsItIsWritten() throws IOException {
    byte[] bytes =
        new CdrWriter()
            .unsignedByte(7)
            .stamp(12_345_678_901L)
            .text("ab")
            .single(1.5f)
            .real(Math.PI)
            .bytes();
    Cdr cdr = new Cdr(ByteBuffer.wrap(bytes));
    assertEquals(7, cdr.unsignedByte());
    assertEquals(12_345_678_901L, cdr.stampNs());
    assertEquals("ab", cdr.text());
    assertEquals(1.5f, cdr.single());
    assertEquals(Math.PI, cdr.real());
    assertThrows(IOException.class, cdr::unsignedByte);
    assertThrows(IOException.class, () -> new Cdr(ByteBuffer.wrap(new byte[] {0, 3, 0, 0})));
  }

  /** Two of them after each other would be no number. */
  @ParameterizedTest
  @ValueSource(doubles = {1.7e308, -1e10, Double.NaN, Double.NEGATIVE_INFINITY})
  void pose_thatNoRobotHas_isRefused(double where) throws IOException {
    for (int place = 0; place < 7; place++) {
      CdrWriter message = new CdrWriter();
      for (int i = 0; i < 7; i++) {
        message.real(i == place ? where : 0.5);
      }
      Cdr cdr = new Cdr(ByteBuffer.wrap(message.bytes()));
      String said = String.valueOf(assertThrows(IOException.class, cdr::rigid).getMessage());
      assertTrue(said.startsWith("has a pose "), said);
    }
  }

  @Test
  void exported_isReadAgain(@TempDir Path folder) throws Exception {
    SensingSetup setup = new SensingSetup(Catalogue.srf04(), new Scene(List.of()), 6);
    List<ReadingRow> rows =
        List.of(
            new ReadingRow("r", "left", 5, Pose.of(1, -2, 0.5), new Echo(1.25)),
            new ReadingRow("r", "left", 5.5, Pose.of(1, -2, 0.5), NoEcho.NO_ECHO));
    BagExport.write(folder, "it's", setup, rows);
    BagTable table = BagTable.of(Recording.read(folder), Set.of("/left"), Optional.of("map"));
    List<String> lines = table.text().lines().toList();
    assertEquals("left,0.000000000,1.000000,2.000000,28.647890,1.25", lines.get(1));
    assertEquals("left,0.500000000,1.000000,2.000000,28.647890,", lines.get(2));
    double cone = setup.sensor().coneHalfAngleRad();
    OptionalDouble said =
        table.settings().getOrDefault("cone", List.of()).stream()
            .mapToDouble(text -> Double.parseDouble(text.replace("deg", "")))
            .findFirst();
    assertEquals(Math.toDegrees(cone), said.orElseThrow(), 1e-3);
  }

  @Test
  void whatIsMissing_isSaid() throws DataFormatException {
    Recording post = Recording.read(BAGS.resolve("post"));
    assertThrows(
        DataFormatException.class, () -> BagTable.of(post, Set.of("/x"), Optional.empty()));
    assertThrows(DataFormatException.class, () -> BagTable.of(post, Set.of(), Optional.of("mars")));
    assertThrows(DataFormatException.class, () -> Recording.read(BAGS.resolve("README.md")));
  }
}
