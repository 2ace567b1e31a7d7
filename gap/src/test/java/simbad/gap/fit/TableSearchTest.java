package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Tables are read off grids that a table decided: 72 bearings, rings 8 cm apart from 12 cm on. */
class TableSearchTest {
  private static final int SIZE = 72;
  private static final double SPACING_M = 0.08;

  /** Near all round, with a lobe on one side. */
  private static double thresholdM(int bearing) {
    return bearing >= 20 && bearing < 30 ? 0.9 : 0.17;
  }

  /** One bearing's pings lose their echo when they are nearer than a distance. */
  private static List<ReadingRow> grid(int deaf, double deafWithinM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int bearing = 0; bearing < SIZE; bearing++) {
      double angle = 2 * Math.PI * bearing / SIZE;
      for (int ring = 0; ring < 15; ring++) {
        double distance = 0.12 + SPACING_M * ring;
        double x = distance * Math.sin(angle);
        double z = distance * Math.cos(angle);
        boolean heard =
            distance < thresholdM(bearing) && !(bearing == deaf && distance < deafWithinM);
        Reading read = heard ? new Echo(distance - 0.05) : NoEcho.NO_ECHO;
        rows.add(
            new ReadingRow("r", "s", 0.05 * rows.size(), Pose.of(x, z, Math.atan2(z, -x)), read));
      }
    }
    return rows;
  }

  private static void check(List<ReadingRow> rows) {
    LogClues clues = new LogClues(Worlds.given(rows), Hypothesis.NONE);
    double[] table = new TableSearch(clues, 0).table();
    for (int bearing = 0; bearing < SIZE; bearing++) {
      assertEquals(thresholdM(bearing), table[bearing], SPACING_M, "bearing " + 5 * bearing);
    }
  }

  @Test
  void table_isThatOfTheGrid() {
    check(grid(-1, 0));
  }

  /** Nearest to the obstacle a bearing has one ping within its threshold. */
  @Test
  void lonePingThatIsLost_makesNoHole() {
    check(grid(50, 0.13));
    check(grid(24, 0.13));
  }

  /** The believed 1.5 m times 0.6 + 0.2 cos b - 0.15 sin 2b, read off as a series. */
  @Test
  void waves_areThoseOfTheThreshold() {
    double[] series = {-0.4, 0.2, 0, 0, -0.15, 0, 0};
    Hypothesis truth = Worlds.effect(Effect.ORIENTATION_SHADOW, "waves:post#0", series);
    List<ReadingRow> rows = Worlds.read(Worlds.poses(4000, 0.1, 1.6, 3), truth, 5);
    double[] found = new TableSearch(new LogClues(Worlds.given(rows), Hypothesis.NONE), 0).waves();
    assertArrayEquals(series, found, 0.03);
  }

  /**
   * Half a metre before the post a miss has 2 % if it is heard and all if it is not; by a
   * thousandth it is anything, of which 30 % are misses. An echo from elsewhere is neither.
   */
  @Test
  void reading_isAMixtureOfHeardAndNot() {
    List<ReadingRow> rows = new ArrayList<>();
    for (Reading read : List.of(NoEcho.NO_ECHO, new Echo(0.45), new Echo(3))) {
      Pose pose = Pose.of(0, 0.5, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), pose, read));
    }
    Hearing hearing = new Hearing(new LogClues(Worlds.given(rows), Hypothesis.NONE), List.of(), 0);
    double heard = 0.999 * 0.02 + 3e-4;
    double silent = 0.999 + 3e-4;
    for (double chance : new double[] {0, 0.25, 1}) {
      assertEquals(
          Math.log(chance * heard + (1 - chance) * silent), hearing.logLikelihood(0, chance), 1e-9);
    }
    double stray = Math.log(1e-3 * 0.7 * 0.01 / 4);
    assertEquals(stray, hearing.logLikelihood(1, 0), 1e-6);
    assertEquals(stray, hearing.logLikelihood(2, 0.5), 1e-6);
    double certain = Math.exp(hearing.logLikelihood(1, 1));
    assertEquals(0.5 * certain, Math.exp(hearing.logLikelihood(1, 0.5)), 1e-5);
  }

  /** Whether anybody looked from the other side changes nothing of what was seen from one. */
  @Test
  void bearings_areReadByThemselves() {
    List<ReadingRow> half =
        grid(-1, 0).stream().filter(row -> row.pose().position().xM() < 0).toList();
    LogClues clues = new LogClues(Worlds.given(half), Hypothesis.NONE);
    double[] table = new TableSearch(clues, 0).table();
    for (int bearing = 38; bearing < 71; bearing++) {
      assertEquals(0.17, table[bearing], SPACING_M, "bearing " + 5 * bearing);
    }
  }
}
