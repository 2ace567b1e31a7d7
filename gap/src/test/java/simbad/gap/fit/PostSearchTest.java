package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A post that is in no scene is found from the echoes that nothing else explains. */
class PostSearchTest {
  private static List<ReadingRow> lookingRound() {
    Random random = new Random(11);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 600; i++) {
      Pose pose =
          Pose.of(
              4 * random.nextDouble() - 2,
              4 * random.nextDouble() - 2,
              2 * Math.PI * random.nextDouble());
      rows.add(new ReadingRow("r", "s", 0.05 * i, pose, NoEcho.NO_ECHO));
    }
    return rows;
  }

  private static LogClues clues(Hypothesis truth) {
    CalibratedLog given = Worlds.given(Worlds.read(lookingRound(), truth, 12));
    return new LogClues(given, Hypothesis.NONE);
  }

  @Test
  void starts_areWhereThePostIs() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "post", 0.9, -0.6, 0.05, 4, 0.95, 90);
    List<double[]> starts = new PostSearch(clues(truth), 4).starts();
    double nearest =
        starts.stream().mapToDouble(s -> Math.hypot(s[0] - 0.9, s[1] + 0.6)).min().orElseThrow();
    assertTrue(nearest < 0.01, "nearest start is " + nearest + " m away");
  }

  /** Every second reading is of a world with another post, every tenth from anywhere. */
  @Test
  void twoPostsAmongStrays_areBothFound() {
    double[][] places = {{0.9, -0.6}, {-1.1, 0.7}};
    List<List<ReadingRow>> worlds = new ArrayList<>();
    for (double[] at : places) {
      worlds.add(
          Worlds.read(
              lookingRound(),
              Worlds.effect(Effect.UNMODELLED_OBJECT, "post", at[0], at[1], 0.05, 4, 0.95, 90),
              12));
    }
    Random random = new Random(13);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 600; i++) {
      ReadingRow row = worlds.get(i % 2).get(i);
      Echo stray = new Echo(random.nextDouble(0.1, 3.9));
      rows.add(
          i % 10 < 9
              ? row
              : new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), stray));
    }
    LogClues both = new LogClues(Worlds.given(rows), Hypothesis.NONE);
    List<double[]> starts = new PostSearch(both, 4).starts();
    for (double[] at : places) {
      double nearest =
          starts.stream()
              .mapToDouble(s -> Math.hypot(s[0] - at[0], s[1] - at[1]))
              .min()
              .orElseThrow();
      assertTrue(nearest < 0.01, "nearest start is " + nearest + " m away");
    }
  }

  @Test
  void starts_reachAsFarAsEchoesCame() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "post", 0.9, -0.6, 0.05, 1.5, 0.95, 90);
    List<double[]> starts = new PostSearch(clues(truth), 4).starts();
    assertTrue(starts.stream().anyMatch(s -> s[3] > 1.3 && s[3] < 1.7));
    assertTrue(starts.stream().anyMatch(s -> s[3] == 4));
  }

  /** Of the echoes of the post all but one in fifty, and half a cell of 6 cm more. */
  @Test
  void reach_isHalfACellBeyondTheEchoes() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "post", 0.9, -0.6, 0.05, 1.5, 0.95, 90);
    LogClues clues = clues(truth);
    double[] ranges = clues.strangeEchoes().mapToDouble(clues.log()::rangeM).sorted().toArray();
    double expected = ranges[(int) Math.rint(0.98 * (ranges.length - 1))] + 0.03;
    List<double[]> starts = new PostSearch(clues, 4).starts();
    double[] own =
        starts.stream()
            .filter(s -> s[3] < 4 && Math.hypot(s[0] - 0.9, s[1] + 0.6) < 0.01)
            .findFirst()
            .orElseThrow();
    assertEquals(expected, own[3], 0.02);
    assertEquals(0.05, own[2], 0.01, "the radius that drew them");
    assertEquals(0.95, own[4]);
  }

  @Test
  void starts_withoutAnyStrangeEcho_areOne() {
    List<ReadingRow> silent = lookingRound().subList(0, 5);
    LogClues clues = new LogClues(Worlds.given(silent), Hypothesis.NONE);
    List<double[]> starts = new PostSearch(clues, 4).starts();
    assertEquals(1, starts.size());
    assertEquals(6, starts.get(0).length);
  }
}
