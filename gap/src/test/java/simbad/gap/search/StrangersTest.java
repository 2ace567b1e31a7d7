package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.gap.calibrate.Calibration;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.change.LevelDrift;
import simbad.sonar.change.LevelScatter;
import simbad.sonar.change.RangeSwing;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.PingLog;

/** Worlds in which something happens that is no effect, and worlds in which nothing of it does. */
class StrangersTest {
  private static final Calibration CALIBRATION =
      Calibration.of(LevelWorlds.POST, new PingLog(LevelWorlds.log(1200, 31)));
  private static final double WORTH_NATS = 20;
  private static final Form DROPOUT =
      Forms.find(Effect.DROPOUT, "single", LevelWorlds.POST, List.of("s")).orElseThrow();

  private static final Form NOISE =
      Forms.find(Effect.RANGE_NOISE, "constant", LevelWorlds.POST, List.of("s")).orElseThrow();

  /** Asks of a log in which something was changed. */
  private static Strangers.Found found(Hypothesis truth, Hypothesis named) {
    return found(truth, named, WORTH_NATS);
  }

  private static Strangers.Found found(Hypothesis truth, Hypothesis named, double worthNats) {
    CalibratedLog given =
        CALIBRATION.given(
            LevelWorlds.POST,
            new PingLog(Worlds.read(LevelWorlds.POST, LevelWorlds.poses(1000, 47), truth, 48)));
    return new Strangers(given, new SetupLeave(given, CALIBRATION)).against(named, worthNats, 1);
  }

  private static Hypothesis with(Change change) {
    Form form = new Form(Optional.empty(), "stranger", List.<Parameter>of(), values -> change);
    return LevelWorlds.truth().and(form);
  }

  @Test
  void whereNothingChanged_nothingIsStrange() {
    double odds = found(LevelWorlds.truth(), Hypothesis.NONE).odds();
    assertTrue(odds < 1 / 99.0, () -> "odds " + odds);
  }

  @Test
  void echoesThatScatter_areNotNone_norDropout() {
    Hypothesis truth = with(new LevelScatter(0, 8));
    Strangers.Found none = found(truth, Hypothesis.NONE);
    assertTrue(none.odds() > 9, none::toString);
    assertTrue(none.what().startsWith("echoes get stronger and weaker from ping to ping, by "));
    Strangers.Found dropout = found(truth, Hypothesis.NONE.and(DROPOUT, 0.2));
    assertTrue(dropout.odds() > 9, dropout::toString);
  }

  @Test
  void strengthThatDrifts_isNotNone() {
    double durationS = 0.05 * 1000;
    Strangers.Found none = found(with(new LevelDrift(0, -4, -9, durationS)), Hypothesis.NONE);
    assertTrue(none.odds() > 9, none::toString);
    assertTrue(none.what().startsWith("the strength of echoes drifts"), none::toString);
  }

  @Test
  void readingsThatSwing_areNotNone_norNoise() {
    Hypothesis truth = with(new RangeSwing(0.02, 0.01, 0.9));
    Strangers.Found none = found(truth, Hypothesis.NONE);
    assertTrue(none.odds() > 9, none::toString);
    assertTrue(none.what().startsWith("readings swing to and fro by 2."), none::toString);
    assertTrue(none.what().endsWith("once in 0.90 s"), none::toString);
    Strangers.Found noise = found(truth, Hypothesis.NONE.and(NOISE, 0.015));
    assertTrue(noise.odds() > 9, noise::toString);
  }

  /** Foam on one side of the post: no effect makes echoes fainter from there alone. */
  private record SoftSide(double decibels) implements LevelChange {
    @Override
    public double addedDb(LevelEars ears, Geometry geometry, int line) {
      return Math.abs(Math.toDegrees(geometry.bearingRad(line)) - 120) < 35 ? -decibels : 0;
    }
  }

  @Test
  void sideThatAnswersFaintly_isNotNone_norDropout() {
    Hypothesis truth = with(new SoftSide(12));
    Strangers.Found none = found(truth, Hypothesis.NONE);
    assertTrue(none.odds() > 9, none::toString);
    assertTrue(
        none.what().matches("echoes are weaker .* at bearings of about 1[0-4]0 degrees"),
        none::toString);
    Strangers.Found dropout = found(truth, Hypothesis.NONE.and(DROPOUT, 0.2));
    assertTrue(dropout.odds() > 9, dropout::toString);
  }

  /** A drift that stays, and a scatter of nothing about another mean, are gains: no strangers. */
  @Test
  void gainStays() {
    Form gain = Forms.find(Effect.GAIN, "level", LevelWorlds.POST, List.of("s")).orElseThrow();
    Strangers.Found found = found(LevelWorlds.truth().and(gain, -5), Hypothesis.NONE.and(gain, -5));
    assertTrue(found.odds() < 1 / 99.0, found::toString);
    assertEquals("", found.what(), "nothing is said of what is not there");
  }

  /** Strong echoes are lost as often as weak ones: nothing of their strength does that. */
  @Test
  void dropoutStays() {
    Hypothesis truth = LevelWorlds.truth().and(DROPOUT, 0.3);
    double odds = found(truth, Hypothesis.NONE.and(DROPOUT, 0.3)).odds();
    assertTrue(odds < 1 / 19.0, () -> "odds " + odds);
  }

  /**
   * Whatever a further effect has to gain: in the place of what is no matter of levels a stranger
   * does not have to gain it, beside all and in the place of a gain it has to.
   */
  @Test
  void strangerInTheirPlace_paysForLevelsAlone() {
    Hypothesis truth = with(new LevelScatter(0, 8));
    Strangers.Found dropout = found(truth, Hypothesis.NONE.and(DROPOUT, 0.2), 1e5);
    assertTrue(dropout.odds() > 9, dropout::toString);
    Form gain = Forms.find(Effect.GAIN, "level", LevelWorlds.POST, List.of("s")).orElseThrow();
    assertEquals(0, found(truth, Hypothesis.NONE.and(gain, -1), 1e5).odds());
    assertEquals(0, found(truth, Hypothesis.NONE, 1e5).odds());
  }
}
