package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Fold;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** What pings say of square posts of 10 cm: their faces are 5 cm before their centres. */
class TrialsTest {
  private static final double EXACT = 1e-9;

  /** Ranges are rounded down to 1 cm. */
  private static final SonarSpec SENSOR = LevelWorlds.POST.sensor();

  private static SensingSetup posts(double... centresZ) {
    List<Obstacle> all = new ArrayList<>();
    for (double z : centresZ) {
      all.add(
          new Obstacle(
              "post " + all.size(),
              new Placement(0, z, 0),
              LevelWorlds.POST.scene().obstacles().get(0).outline(),
              new UniformDetection(1.5)));
    }
    return new SensingSetup(SENSOR, new Scene(all), 4);
  }

  /** A ping from each height above the origin, straight at it. */
  private static PingLog log(double[] fromZ, double... readM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < fromZ.length; i++) {
      Reading read = readM[i] > 0 ? new Echo(readM[i]) : NoEcho.NO_ECHO;
      rows.add(new ReadingRow("r", "s", 0.1 * i, Pose.of(0, fromZ[i], Math.PI / 2), read));
    }
    return new PingLog(rows);
  }

  private static List<Trials.Trial> trials(SensingSetup setup, Fold fold, PingLog log) {
    Geometry geometry = new Geometry(log, setup, List.of(LevelRule.of(SENSOR)));
    return Trials.of(geometry, SENSOR, fold, List.of());
  }

  private static double[] at(double... z) {
    return z;
  }

  /** From 1 m the face is 95 cm away. It was read at 97, between 97 and 98: 2.5 cm beyond. */
  @Test
  void anEchoIsReadBeyondTheNearestPoint() {
    Trials.Trial only = trials(posts(0), Fold.ALL, log(at(1), 0.97)).get(0);

    assertTrue(only.isRead());
    assertEquals(1, only.centreM(), EXACT);
    assertEquals(0.95, only.nearestM(), EXACT);
    assertEquals(0.025, only.beyondM(), EXACT);
    assertEquals(0, only.offAxisRad(), EXACT);
    assertEquals(1, only.share(), 0);
    assertEquals(0, only.ping());
    assertEquals(0, only.target());
  }

  @Test
  void silenceTriesEveryPost() {
    List<Trials.Trial> all = trials(posts(0, -0.5), Fold.ALL, log(at(1), 0));

    assertEquals(2, all.size());
    assertTrue(all.stream().noneMatch(Trials.Trial::isRead));
    assertEquals(1, all.get(1).target());
    assertEquals(1.45, all.get(1).nearestM(), EXACT);
  }

  /** The farther one answered: the nearer one was silent. The nearer one: it hides the other. */
  @Test
  void aNearerEchoHidesWhatIsBehind() {
    List<Trials.Trial> both = trials(posts(0, -0.5), Fold.ALL, log(at(1), 1.45));
    List<Trials.Trial> near = trials(posts(0, -0.5), Fold.ALL, log(at(1), 0.95));

    assertEquals(List.of(false, true), both.stream().map(Trials.Trial::isRead).toList());
    assertEquals(1, near.size());
    assertEquals(0, near.get(0).target());
    assertTrue(near.get(0).isRead());
  }

  /** 3 cm apart are one event at the receiver, 4 cm are two. */
  @Test
  void whatIsHardlyNearerIsNotTried() {
    assertEquals(1, trials(posts(0, -0.03), Fold.ALL, log(at(1), 0.98)).size());
    assertEquals(2, trials(posts(0, -0.04), Fold.ALL, log(at(1), 0.99)).size());
  }

  /** 20 cm from every post's nearest point on, a reading has to do with none of them. */
  @Test
  void aStrangerSaysNothing() {
    assertEquals(0, trials(posts(0), Fold.ALL, log(at(1), 1.2)).size());
    assertEquals(1, trials(posts(0), Fold.ALL, log(at(1), 1.1)).size());
    assertEquals(0, trials(posts(0), Fold.ALL, log(at(1), 0.7)).size());
  }

  /** The sensor hears from 2 cm to 4 m. */
  @Test
  void whatIsOutOfRangeIsNotTried() {
    assertEquals(0, trials(posts(0), Fold.ALL, log(at(4.1), 0)).size());
    assertEquals(1, trials(posts(0), Fold.ALL, log(at(4), 0)).size());
    assertEquals(0, trials(posts(0), Fold.ALL, log(at(0.06), 0)).size());
  }

  @Test
  void onlyPingsThatAreHeldCount() {
    List<Trials.Trial> all = trials(posts(0), i -> i == 1, log(at(1, 2), 0, 0));

    assertEquals(1, all.size());
    assertEquals(1, all.get(0).ping());
    assertEquals(2, all.get(0).centreM(), EXACT);
  }

  @Test
  void whatIsAddedToATrialIsItsLevel() {
    Trials.Trial trial = new Trials.Trial(3, 1, 0.5, 1.2, 1.1, 0.1, true, 2, 1, 0);

    assertEquals(
        new Trials.Trial(3, 1, 0.5, 1.2, 1.1, 0.1, true, 5, 0.5, 0.01), trial.plus(3, 0.5, 0.01));
  }

  private static Limits limits(Fold fold, PingLog log) {
    SonarSpec sheet = SENSOR.withRange(0.6, 1);
    return Limits.of(new Geometry(log, posts(0), List.of(LevelRule.of(SENSOR))), sheet, fold);
  }

  private static final double[] NEAR = at(0.55, 0.45, 0.5);

  /** Three faces at 50, 40 and 45 cm were heard, and the sheet says 60. */
  @Test
  void threeReadingsMoveTheNearLimit() {
    Limits limits = limits(Fold.ALL, log(NEAR, 0.5, 0.4, 0.45));

    assertEquals(new Limits(0.4, 1), new Limits(Math.rint(limits.leastM() * 1e6) / 1e6, 1));
    assertEquals(1, limits.mostM(), 0);
    assertEquals(0.4, limits.of(SENSOR).minRangeM(), EXACT);
    assertEquals(1, limits.of(SENSOR).maxRangeM(), EXACT);
  }

  /** Two are strays; silence, what is not near the face and what is not held do not count. */
  @Test
  void fewerReadingsMoveNothing() {
    assertEquals(0.6, limits(Fold.ALL, log(NEAR, 0.5, 0.4, 0)).leastM(), 0);
    assertEquals(0.6, limits(Fold.ALL, log(NEAR, 0.5, 0.4, 0.56)).leastM(), 0);
    assertEquals(0.6, limits(i -> i > 0, log(NEAR, 0.5, 0.4, 0.45)).leastM(), 0);
    // The face or the reading is inside of the limit.
    assertEquals(0.6, limits(Fold.ALL, log(at(0.55, 0.45, 0.7), 0.5, 0.4, 0.58)).leastM(), 0);
    assertEquals(0.6, limits(Fold.ALL, log(at(0.55, 0.45, 0.62), 0.5, 0.4, 0.61)).leastM(), 0);
  }

  /** The farthest face is 1.5 m away: beyond it a tenth was not tried. */
  @Test
  void threeReadingsMoveTheFarLimit() {
    double[] far = at(1.35, 1.55, 1.45);

    assertEquals(1.65, limits(Fold.ALL, log(far, 1.3, 1.5, 1.4)).mostM(), EXACT);
    assertEquals(0.6, limits(Fold.ALL, log(far, 1.3, 1.5, 1.4)).leastM(), 0);
    assertEquals(1, limits(Fold.ALL, log(far, 1.3, 1.5, 0)).mostM(), 0);
    // A reading under the limit though the face lies over it.
    assertEquals(1, limits(Fold.ALL, log(at(1.35, 1.55, 1.06), 1.3, 1.5, 0.99)).mostM(), 0);
  }
}
