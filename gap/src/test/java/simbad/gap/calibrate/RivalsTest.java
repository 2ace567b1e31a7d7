package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.sensing.ReadingRow;

class RivalsTest {
  private static final List<ReadingRow> OF_LEVELS = LevelWorlds.log(1200, 31);
  private static final List<ReadingRow> OF_THRESHOLDS =
      Worlds.read(LevelWorlds.poses(1200, 32), Hypothesis.NONE, 33);

  @Test
  void theLawThatTheWorldFollowsIsTaken() {
    assertTrue(new Rivals(Worlds.POST, new PingLog(OF_LEVELS)).gainedNats() > 0);
    assertTrue(new Rivals(Worlds.POST, new PingLog(OF_THRESHOLDS)).gainedNats() < 0);
  }

  @Test
  void theCalibrationSaysWhichAndHowFarItIsOff() {
    Calibration level = taken(new PingLog(OF_LEVELS));
    Calibration threshold = taken(new PingLog(OF_THRESHOLDS));

    assertEquals(SensorLaw.Model.LEVEL, level.model());
    assertTrue(level.modelError().isPresent());
    assertEquals(SensorLaw.Model.THRESHOLD, threshold.model());
    assertTrue(threshold.modelError().isEmpty());
  }

  /** A log that says the same as its reference has no other word. */
  private static Calibration taken(PingLog log) {
    return Laws.of(Worlds.POST, log, log).get(0).calibration();
  }

  @Test
  void aSceneThatStatesItsLawIsBelieved() {
    Calibration stated =
        Calibration.of(Worlds.POST.under(SensorLaw.Model.THRESHOLD), new PingLog(OF_LEVELS));

    assertEquals(SensorLaw.Model.THRESHOLD, stated.model());
  }

  /** Of a world that is as the law says, sums over blocks vary as those of independent pings. */
  @Test
  void aRightLawIsOffByChanceAlone() {
    ModelError right = ModelError.ofLevel(LevelWorlds.POST, new PingLog(OF_LEVELS));

    assertEquals(OF_LEVELS.size(), right.rows());
    assertBetween(1.0, 1.8, right.echoes());
    assertBetween(1.0, 1.8, right.ranges());
    assertBetween(0.7, 1.3, right.gapM() / right.expectedM());
  }

  /** What no row was fitted on shows: a world of thresholds hangs together under the level law. */
  @Test
  void aWrongLawIsOffByMoreHoweverManyRowsThereAre() {
    ModelError wrong = ModelError.ofLevel(LevelWorlds.POST, new PingLog(OF_THRESHOLDS));
    ModelError right = ModelError.ofLevel(LevelWorlds.POST, new PingLog(OF_LEVELS));

    assertTrue(wrong.gapM() > 1.5 * right.gapM());
  }

  private static void assertBetween(double low, double high, double value) {
    assertTrue(value >= low && value <= high, value + " is not in [" + low + ", " + high + "]");
  }
}
