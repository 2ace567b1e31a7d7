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

class LawsTest {
  private static PingLog ofLevels(int rows, long seed) {
    return new PingLog(LevelWorlds.log(rows, seed));
  }

  private static PingLog ofThresholds(int rows, long seed) {
    List<ReadingRow> poses = LevelWorlds.poses(rows, seed);
    return new PingLog(Worlds.read(poses, Hypothesis.NONE, seed + 1));
  }

  private static List<SensorLaw.Model> laws(PingLog reference, PingLog log) {
    return Laws.of(Worlds.POST, reference, log).stream()
        .map(law -> law.calibration().model())
        .toList();
  }

  @Test
  void whereReferenceAndLogAgreeOneLawIsLeft() {
    assertEquals(List.of(SensorLaw.Model.LEVEL), laws(ofLevels(1200, 31), ofLevels(400, 51)));
    assertEquals(
        List.of(SensorLaw.Model.THRESHOLD), laws(ofThresholds(1200, 32), ofThresholds(400, 52)));
  }

  /** Far more rows of another world than the reference has: it may have been preferred by luck. */
  @Test
  void aLogThatRefutesTheReferenceBringsTheOtherLawIn() {
    assertEquals(
        List.of(SensorLaw.Model.THRESHOLD, SensorLaw.Model.LEVEL),
        laws(ofThresholds(300, 33), ofLevels(2500, 53)));
  }

  @Test
  void aSceneThatStatesItsLawIsBelieved() {
    List<Laws.Law> stated =
        Laws.of(Worlds.POST.under(SensorLaw.Model.THRESHOLD), ofLevels(400, 34), ofLevels(400, 54));

    assertEquals(1, stated.size());
    assertEquals(SensorLaw.Model.THRESHOLD, stated.get(0).calibration().model());
  }

  @Test
  void theRightLawForetellsReferenceAndLogBetter() {
    PingLog log = ofLevels(2500, 55);
    List<Laws.Law> both = Laws.of(Worlds.POST, ofThresholds(300, 33), log);
    double first = nats(both.get(0), log);
    double second = nats(both.get(1), log);

    assertTrue(second > first + 20, second + " beside " + first);
  }

  private static double nats(Laws.Law law, PingLog log) {
    return law.nats(law.calibration().given(Worlds.POST, log), law.calibration(), Hypothesis.NONE);
  }
}
