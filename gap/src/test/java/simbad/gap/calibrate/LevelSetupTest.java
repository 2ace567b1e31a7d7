package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensorLaw;

/** A level law that a short reference calibrated, and what it leaves open in a log. */
class LevelSetupTest {
  private static final Calibration LEVEL =
      Calibration.of(LevelWorlds.POST, new PingLog(LevelWorlds.log(500, 61)));

  private static final PingLog LOG = new PingLog(LevelWorlds.log(250, 71));
  private static final CalibratedLog GIVEN = LEVEL.given(Worlds.POST, LOG);

  private static Hypothesis gain(double decibels) {
    Form form = Forms.find(Effect.GAIN, "level", LevelWorlds.POST, List.of("s")).orElseThrow();
    return Hypothesis.NONE.and(form, decibels);
  }

  private static double nats(CalibratedLog given, Hypothesis set) {
    return Arrays.stream(given.logLikelihood(set)).sum();
  }

  @Test
  void itsDoubtsAreThoseOfRowsThatWereHeldOut() {
    ModelError error = LEVEL.modelError().orElseThrow();

    assertTrue(LEVEL.isHeldOut());
    assertTrue(LEVEL.leeway().isPresent());
    assertArrayEquals(new double[] {error.echoes(), error.ranges()}, LEVEL.blocksVary(), 0);
    assertEquals(error.gapTimes(), LEVEL.gapTimes(), 0);
    assertEquals(error.misfitTimes(0.7, 9000), LEVEL.misfitTimes(0.7, 9000), 0);
    assertTrue(LEVEL.misfitTimes(0.01, 9000) > 1);
    assertEquals(1, LEVEL.clumping(), 0);
    assertEquals(1, LEVEL.rangeClumping(), 0);
    assertEquals(500, error.rows());
  }

  @Test
  void aLogIsSeenUnderTheLawThatWasTaken() {
    assertEquals(SensorLaw.Model.LEVEL, LEVEL.model());
    assertTrue(LEVEL.believed(Worlds.POST).sensor().law().isLevel());
    assertEquals(LEVEL.setup().changes(), GIVEN.calibration());
    // All that it says is divided by what sums over blocks vary by.
    CalibratedLog plain = new CalibratedLog(LevelWorlds.POST, LEVEL.setup().changes(), LOG);
    ModelError error = LEVEL.modelError().orElseThrow();
    double[] divided = plain.divided(error.echoes(), error.ranges()).logLikelihood(Hypothesis.NONE);
    assertArrayEquals(divided, GIVEN.logLikelihood(Hypothesis.NONE), 0);
  }

  /** What moves takes what is likeliest: it can but gain, and more where more is off. */
  @Test
  void aSetupMovesTowardsALogThatIsOff() {
    double right = LEVEL.leewayNats(GIVEN, Hypothesis.NONE);
    double off = LEVEL.leewayNats(GIVEN, gain(4));

    assertTrue(right >= 0, () -> "right " + right);
    assertTrue(off > right + 1, () -> off + " beside " + right);
    assertEquals(0, Calibration.none().leewayNats(GIVEN, gain(4)), 0);
  }

  /** Levels alone are a part of what levels and ranges gain. */
  @Test
  void rangesMoveBesideLevels() {
    SetupMove move = new SetupMove(LEVEL.leeway().orElseThrow(), GIVEN, gain(4));
    double levels = move.levels().nats();

    assertEquals(LEVEL.leewayNats(GIVEN, gain(4)), move.nats(move.levels()), 1e-9);
    assertTrue(move.nats(move.levels()) > levels);
    assertTrue(move.logShare() < 0);
    assertTrue(move.geometry().log().size() == 250 && move.line(0) <= 0);
  }

  /** Where nothing is explained the levels move at once; beside an explanation they wait. */
  @Test
  void aLogIsOpenedWhileNothingIsExplained() {
    CalibratedLog opened = LEVEL.opened(GIVEN, Hypothesis.NONE);

    assertEquals(GIVEN.calibration().size() + 1, opened.calibration().size());
    assertTrue(nats(opened, Hypothesis.NONE) > nats(GIVEN, Hypothesis.NONE));
    assertSame(GIVEN, LEVEL.opened(GIVEN, gain(4)));
  }

  @Test
  void withoutAValueThatIsOffOnlyTheSetupMoves() {
    SetupLeave leave = new SetupLeave(GIVEN, LEVEL);

    assertEquals(leave.nats(Hypothesis.NONE), leave.natsWithValues(Hypothesis.NONE), 1e-9);
    assertEquals(LEVEL.leewayNats(GIVEN, Hypothesis.NONE), leave.nats(Hypothesis.NONE), 0);
    assertTrue(leave.leeway().isPresent());
  }

  /**
   * A gain of 4 dB that is not there: the value itself goes towards 0, by which the log becomes
   * likelier than the set-up alone could make it.
   */
  @Test
  void aValueMovesWithTheSetup() {
    SetupLeave leave = new SetupLeave(GIVEN, LEVEL);
    double alone = leave.nats(gain(4));
    double both = leave.natsWithValues(gain(4));
    double three = 3 * 0.12 * 4;
    double there = nats(GIVEN, gain(4 - three)) - nats(GIVEN, gain(4));

    assertTrue(both > alone + 1, () -> both + " beside " + alone);
    // Three steps at most, of 0.12 of what it is away from nothing; and the set-up moves too.
    double most = there + leave.nats(gain(4 - three));
    assertTrue(both < most + 1, () -> both + " beside " + most);
  }

  /** Places and tables are no matter of a parabola. */
  @Test
  void aFormOfManyValuesStays() {
    Form near = LevelForms.nearRange();
    Hypothesis set = Hypothesis.NONE.and(near, 0.02, 0.02, 0.02, 0.02);
    SetupLeave leave = new SetupLeave(GIVEN, LEVEL);

    assertEquals(leave.nats(set), leave.natsWithValues(set), 1e-9);
  }

  @Test
  void underTheThresholdRuleNothingMoves() {
    PingLog log = new PingLog(Worlds.read(LevelWorlds.poses(60, 5), Hypothesis.NONE, 6));
    SetupLeave leave =
        new SetupLeave(new CalibratedLog(Worlds.POST, List.of(), log), Calibration.none());

    assertFalse(leave.leeway().isPresent());
    assertEquals(0, leave.nats(gain(4)), 0);
    assertEquals(0, leave.natsWithValues(gain(4)), 0);
  }
}
