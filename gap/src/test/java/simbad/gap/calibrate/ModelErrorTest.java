package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.SetupError;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.unexplained.SetupScores;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** What a set-up is off by, in figures worked by hand. */
class ModelErrorTest {
  private static final double EXACT = 1e-12;

  private static ModelError error(double gapM, double expectedM, double misfit) {
    return new ModelError(400, gapM, expectedM, 1.5, 1.2, misfit, 0.3, 0.002);
  }

  /** Twice what chance makes; four times the rows show that twice as surely. */
  @Test
  void whatIsWrongShowsMoreSurelyInMoreRows() {
    assertEquals(2, error(0.02, 0.01, 3).misfitTimes(1.5, 400), EXACT);
    assertEquals(4, error(0.02, 0.01, 3).misfitTimes(1.5, 1600), EXACT);
    assertEquals(1, error(0.02, 0.01, 3).misfitTimes(1.5, 50), 0);
  }

  @Test
  void aGapIsAtLeastWhatIsExpected() {
    assertEquals(2, error(0.02, 0.01, 3).gapTimes(), EXACT);
    assertEquals(1, error(0.005, 0.01, 3).gapTimes(), 0);
    assertEquals(1, error(0.02, 0, 3).gapTimes(), 0);
  }

  @Test
  void aDiagnosisSaysItInCentimetres() {
    SetupError said = error(0.02, 0.0125, 3).finding();

    assertEquals(new SetupError(400, 2, 1.25, 1.5, 1.2, 3), said);
  }

  @Test
  void whatIsNoNumberIsRefused() {
    for (int i = 0; i < 7; i++) {
      double[] v = {0.02, 0.01, 1.5, 1.2, 3, 0.3, 0.002};
      v[i] = Double.NaN;
      assertThrows(
          IllegalArgumentException.class,
          () -> new ModelError(400, v[0], v[1], v[2], v[3], v[4], v[5], v[6]),
          "figure " + i);
    }
  }

  /** Two posts half a metre apart; pings from above look at both. */
  private static Geometry geometry(double... fromZ) {
    List<Obstacle> posts = new ArrayList<>();
    for (double z : new double[] {0, -0.5}) {
      Obstacle post = LevelWorlds.POST.scene().obstacles().get(0);
      Placement at = new Placement(0, z, 0);
      posts.add(new Obstacle("post " + posts.size(), at, post.outline(), post.detection()));
    }
    List<ReadingRow> rows = new ArrayList<>();
    for (double z : fromZ) {
      // From below the second post is the nearer one.
      double heading = z > 0 ? Math.PI / 2 : -Math.PI / 2;
      Pose pose = Pose.of(0, z, heading);
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), pose, NoEcho.NO_ECHO));
    }
    SensingSetup setup = new SensingSetup(LevelWorlds.POST.sensor(), new Scene(posts), 4);
    return new Geometry(new PingLog(rows), setup, List.of(LevelRule.of(setup.sensor())));
  }

  private static PlaceError places(Geometry geometry, double[] perDecibel, double[] perMetre) {
    PlaceError error = new PlaceError(2);
    error.take(new SetupScores(geometry, perDecibel, perMetre), ping -> true);
    return error;
  }

  /** At one place a sum of 4 with an information of 4: 16 / 4 - 1 too much, over 4. */
  @Test
  void whatIsOffTogetherIsMoreThanChance() {
    PlaceError error = places(geometry(1, 1, 1, 1), ones(4), new double[4]);

    assertEquals(Math.sqrt(3 / 4.0), error.excessDb(), EXACT);
    assertEquals(0, error.rangeM(), 0);
  }

  /** 5 over the place's 25 is as chance is; a sum of 0 is less than that. */
  @Test
  void whatCancelsIsLessThanChance() {
    assertEquals(0, places(geometry(1, 1), new double[2], new double[] {1, -1}).rangeM(), 0);
    assertEquals(0, places(geometry(1), new double[] {5}, new double[1]).excessDb(), EXACT);
  }

  /** 3 too much at one place and 1 too little at the other: 2, over 4 and 8. */
  @Test
  void placesAddUp() {
    double[] slope = {1, 1, 1, 1, 2, -2};
    double expected = Math.sqrt(2 / 12.0);

    assertEquals(
        expected, places(geometry(1, 1, 1, 1, 2, 2), slope, new double[6]).excessDb(), EXACT);
    // As far from the other post on its other side.
    assertEquals(
        expected, places(geometry(1, 1, 1, 1, -1.5, -1.5), new double[6], slope).rangeM(), EXACT);
  }

  private static double[] ones(int size) {
    double[] all = new double[size];
    Arrays.fill(all, 1);
    return all;
  }

  /** Two lines of sight for each ping. */
  @Test
  void aShiftIsThatOfItsPing() {
    Geometry geometry = geometry(1, 2);
    LevelShift shift = new LevelShift(new double[] {0.5, -2});
    List<Change> before = List.of(LevelRule.of(LevelWorlds.POST.sensor()));

    assertEquals(0.5, shift.addedDb(Objects.requireNonNull(geometry.ears()), geometry, 1), 0);
    assertEquals(-2, shift.addedDb(Objects.requireNonNull(geometry.ears()), geometry, 2), 0);
    assertEquals(List.of(before.get(0), shift), shift.and(before));
  }
}
