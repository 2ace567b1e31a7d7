package simbad.experiments.dataset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.ThresholdTable;

class MadeDataSetTest {
  private static final String LADDER = "set,note,true_cm,n,reading_cm\n";

  @TempDir private Path folder = Path.of("target");

  /**
   * At each of its bearings, echoes come from inside the table's threshold and not from outside.
   */
  @Test
  void grid_isDecidedByTheTable() {
    ThresholdTable table = Catalogue.angleTable().table();
    MadeDataSet made =
        TableGrid.of(
            Catalogue.find("angle").orElseThrow(), Catalogue.srf04(), new SplittableRandom(1));
    Obstacle angle = made.setup().scene().obstacles().get(0);
    assertEquals(2.5, angle.detection().thresholdM(1));
    int wrong = 0;
    for (ReadingRow row : made.readings()) {
      Point place = row.pose().position();
      double threshold =
          table.thresholdM(angle.worldFromObstacle().bearingRad(place.xM(), place.zM()));
      double beyond = Math.hypot(place.xM(), place.zM()) - threshold;
      assertEquals(0, row.pose().offAxisRad(new Point(0, 0)), 1e-9);
      if (Math.abs(beyond) > 0.2) {
        wrong += row.reading() instanceof Echo == beyond < 0 ? 0 : 1;
      }
    }
    // One in two hundred echoes is missed, as the sensor's file says.
    assertTrue(wrong <= 20, "wrong: " + wrong);
    assertEquals(72 * 42, made.readings().size());
  }

  /** What the nominal model expects of a board at a true distance is that distance. */
  @Test
  void ladder_looksSquarelyAtTheBoard() throws Exception {
    Path log =
        Files.writeString(
            folder.resolve("log.csv"),
            LADDER + "a,x,123.4,1,120\nb,x,5,1,5\na,,,1,5\na,y,10,1,9\n");
    MadeDataSet made = LadderLog.read(log, rows("a", "y"), 340);
    assertEquals(1, made.readings().size());
    ReadingRow row = made.readings().get(0);
    assertEquals(new Echo(1.2), row.reading());
    NominalModel model = new NominalModel(made.setup().sensor(), made.setup().scene());
    assertEquals(1.234, model.sight(0, row.pose()).nearestM().orElseThrow(), 1e-12);
    assertEquals(340, made.setup().sensor().assumedSoundSpeedMPerS());
  }

  /** Before the ball's middle the ball is where the distance says, and the board behind it too. */
  @Test
  void plotter_looksAtBallAndBackdrop() throws Exception {
    Path log =
        Files.writeString(
            folder.resolve("log.csv"), "x,y,ultra\n88,76,20\n88,80,765\n88,120,20\n0,76,33\n");
    MadeDataSet made =
        PlotterLog.read(log, new PlotterLog.Setup(88, 76, 190, OptionalDouble.of(400)));
    assertEquals(
        List.of(new Echo(0.2), NoEcho.NO_ECHO, new Echo(0.33)),
        made.readings().stream().map(ReadingRow::reading).toList());
    Pose middle = made.readings().get(0).pose();
    NominalModel model = new NominalModel(made.setup().sensor(), made.setup().scene());
    assertEquals(0.19, model.sight(0, middle).nearestM().orElseThrow(), 1e-3);
    assertEquals(0.4, model.sight(1, middle).nearestM().orElseThrow(), 1e-12);
    assertEquals(-0.088, made.readings().get(2).pose().position().xM(), 1e-12);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "set,note,true_cm\\na,b,1 | :1: reading_cm: column is missing",
        "set,note,true_cm,reading_cm\\na,b,1,far | :2: reading_cm: 'far' is not a number",
        "set,note,true_cm,reading_cm\\na,b,-1,2 | :2: true_cm: '-1' is not a number",
        "set,note,true_cm,reading_cm\\na,b,1,1e300 | :2: reading_cm: '1e300' is not a number",
        "set,note,true_cm,reading_cm\\na,b,1,NaN | :2: reading_cm: 'NaN' is not a number",
        "set,note,true_cm,reading_cm\\nc,b,1,2 | has no row of set 'a'",
        "set,note,true_cm,reading_cm | has no rows",
        "set,note,true_cm,reading_cm\\na,b,1 | :2: reading_cm: '' is not a number"
      })
  void badLog_isNamed(String text, String problem) throws Exception {
    Path log = Files.writeString(folder.resolve("log.csv"), text.replace("\\n", "\n"));
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> LadderLog.read(log, rows("a", "gone"), 340));
    assertTrue(fault.toString().contains(problem), fault.toString());
  }

  private static LadderLog.Rows rows(@Nullable String set, @Nullable String skip) {
    return new LadderLog.Rows(Optional.ofNullable(set), Optional.ofNullable(skip));
  }

  /** Which rows are taken; a column is wanted only where an option is about it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      nullValues = "-",
      value = {
        "set,note,true_cm,reading_cm | a | - | 1 2 3",
        "set,note,true_cm,reading_cm | a | x | 2 3",
        "set,note,true_cm,reading_cm | a | '' | 1 3",
        "set,note,true_cm,reading_cm | - | - | 1 2 3 4",
        "set,note,true_cm,reading_cm | - | x | 2 3",
        "set,other,true_cm,reading_cm | a | - | 1 2 3",
        "other,note,true_cm,reading_cm | - | y | 1 2 4",
        "one,other,true_cm,reading_cm | - | - | 1 2 3 4"
      })
  void ladder_takesTheRowsThatAreAskedFor(
      String head, @Nullable String set, @Nullable String skip, String taken) throws Exception {
    Path log =
        Files.writeString(
            folder.resolve("log.csv"), head + "\na,x,10,100\na,,10,200\na,y,10,300\nb,x,10,400\n");
    assertEquals(
        taken,
        LadderLog.read(log, rows(set, skip), 340).readings().stream()
            .map(row -> Long.toString(Math.round(((Echo) row.reading()).rangeM())))
            .collect(Collectors.joining(" ")));
  }

  @ParameterizedTest
  @CsvSource({"a,,set", ",x,note"})
  void ladder_wantsTheColumnThatAnOptionIsAbout(
      @Nullable String set, @Nullable String skip, String column) throws Exception {
    Path log = Files.writeString(folder.resolve("log.csv"), "true_cm,reading_cm\n1,1\n");
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> LadderLog.read(log, rows(set, skip), 340));
    assertTrue(fault.toString().contains(":1: " + column + ": column is missing"), fault + "");
  }
}
