package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.DataSet;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class ReferenceWordsTest {
  private static final SensingSetup SETUP = Samples.data("grid").setup();

  /** Rows a second apart, all from one distance of the first obstacle. */
  private static List<ReadingRow> rows(int count, double distanceM) {
    Point centre =
        SETUP.scene().obstacles().get(0).worldFromObstacle().worldFromObstacle(new Point(0, 0));
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Pose pose = Pose.of(centre.xM() + distanceM, centre.zM(), Math.PI);
      rows.add(new ReadingRow("r", "s", i, pose, NoEcho.NO_ECHO));
    }
    return rows;
  }

  private static Optional<String> words(List<ReadingRow> rows, List<ReadingRow> reference) {
    return ReferenceWords.of(new DataSet("one", SETUP, rows, reference));
  }

  /** Seven hundred rows at one a second are 11.7 minutes. */
  @Test
  void withoutOne_itSaysWhatThatCosts() {
    String words = words(rows(1000, 1), List.of()).orElseThrow();

    assertTrue(words.startsWith("There is no reference."), words);
    assertTrue(words.contains("Some 12 minutes of readings of the same set-up"), words);
    assertTrue(
        words(rows(1, 1), List.of()).orElseThrow().contains("700 readings of the same set-up"));
  }

  @Test
  void whereItWasTaken_itSaysNothing() {
    assertEquals(Optional.empty(), words(rows(100, 1.1), rows(10, 1.2)));
  }

  @Test
  void elsewhere_itSaysHowMuch() {
    List<ReadingRow> both = rows(75, 1.1);
    both.addAll(rows(25, 2.2));
    String words = words(both, rows(10, 1.2)).orElseThrow();

    assertTrue(words.startsWith("25\u00a0% of the readings come from"), words);
  }
}
