package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sonar.format.DataFormatException;

class TuningSurveyTest {
  private static final String ROWS =
      """
      sensor,status,controller.angle_deg,controller.curl,mean_abs_cm,simulated_s
      original,done,1,0.1,100,50
      original,done,1,0.1,102,70
      original,done,2,0.1,101.5,50
      shadow,done,1,0.1,8,55
      shadow,done,2,0.1,2,90
      shadow,failed,2,0.1,,
      shadow,done,3,0.1,,10
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private TuningSurvey tuning(String rows) throws Exception {
    Path file = Files.writeString(folder.resolve("results.csv"), rows);
    return TuningSurvey.read(file, "angle_deg", Optional.of("curl"));
  }

  @Test
  void read_severalRunsOfASetting_areMeant() throws Exception {
    TuningSurvey tuning = tuning(ROWS);
    assertEquals(
        new TuningSurvey.Setting("original", 1, 0.1, 101, 60, 2),
        tuning.onCurve("original", 0.1).get(0));
    assertEquals(2, tuning.leftOut());
    assertEquals(List.of("original", "shadow"), tuning.sensors());
  }

  @Test
  void chosenWith_sameErrorEverywhere_isTheFastest() throws Exception {
    TuningSurvey tuning = tuning(ROWS);
    assertTrue(tuning.isIndifferent("original"));
    assertEquals(2, tuning.chosenWith("original").along());
    assertFalse(tuning.isIndifferent("shadow"));
    assertEquals(2, tuning.chosenWith("shadow").along());
    TuningSurvey.Setting choice = new TuningSurvey.Setting("original", 1, 0.1, 0, 0, 1);
    assertEquals(8, tuning.judgedBy("shadow", choice).orElseThrow().errorCm());
  }

  /** The mean is over the curl too, and says so. */
  @Test
  void read_oneParameter_namesWhatTheMeansAreOver() throws Exception {
    Path file = Files.writeString(folder.resolve("results.csv"), ROWS + "shadow,done,2,0.3,4,70\n");
    TuningSurvey tuning = TuningSurvey.read(file, "angle_deg", Optional.empty());
    assertEquals(List.of(0.0), tuning.curves("shadow"));
    assertEquals(
        List.of(
            new TuningSurvey.Setting("shadow", 1, 0, 8, 55, 1),
            new TuningSurvey.Setting("shadow", 2, 0, 3, 80, 2)),
        tuning.onCurve("shadow", 0));
    assertEquals(List.of("curl"), tuning.averaged());
    assertEquals(List.of(), tuning(ROWS).averaged());
    assertEquals(List.of("original"), tuning.only(List.of("original")).sensors());
  }

  @Test
  void read_columnThatIsNotThere_isNamed() throws Exception {
    Path file = Files.writeString(folder.resolve("results.csv"), ROWS);
    DataFormatException fault =
        assertThrows(
            DataFormatException.class,
            () -> TuningSurvey.read(file, "angle_deg", Optional.of("speed")));
    assertEquals(
        file + ": no parameter 'speed', expected one of angle_deg, curl", fault.getMessage());
  }

  @Test
  void read_noUsableRow_isRefused() {
    String header = ROWS.lines().findFirst().orElseThrow() + "\n";
    assertThrows(DataFormatException.class, () -> tuning(header + "shadow,failed,1,1,,\n"));
  }
}
