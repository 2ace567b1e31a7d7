package simbad.gap.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.IntervalWidths;
import simbad.motion.Robot;
import simbad.sonar.effect.Form;

/** What readings of a post say of one value, beside what was found in them. */
class HeardTest {
  private static final double OFFSET_M = 0.05;
  private static final double LOST = 0.3;
  private static final Hypothesis DROPOUT = Worlds.effect(Effect.DROPOUT, "single", LOST);
  private static final Form LOSES = DROPOUT.forms().get(0);
  private static final Form SHIFTS =
      Worlds.effect(Effect.RANGE_OFFSET, "constant", OFFSET_M).forms().get(0);
  private static final Hypothesis BOTH = DROPOUT.and(SHIFTS, OFFSET_M);
  private static final DataSet DATA =
      new DataSet(
          "post", Worlds.POST, Worlds.read(Worlds.poses(400, 0.3, 1.3, 1), BOTH, 2), List.of());

  private static Diagnosis found(Hypothesis fitted) {
    return SensingHalf.of(Verdict.EXPLAINED, 0, fitted.effects(), fitted);
  }

  private static Estimate estimate(Hypothesis fitted, Form form, double offered) {
    return new Heard(DATA, found(fitted)).estimate(form, offered);
  }

  /**
   * Some 280 echoes that scatter by 5 mm and come in steps of 1 cm tell the shift to about half a
   * millimetre; a share of 0.3 of 400 is known to 0.023.
   */
  @Test
  void value_isTheOneOfTheReadings_whateverWasFoundOrOffered() {
    for (Hypothesis fitted : List.of(Hypothesis.NONE, DROPOUT, BOTH)) {
      for (double offered : new double[] {0, OFFSET_M, 7}) {
        Estimate shift = estimate(fitted, SHIFTS, offered);
        assertEquals(OFFSET_M, shift.value(), 0.003, fitted + " offered " + offered);
        assertTrue(shift.deviation() < 0.002, shift::toString);
      }
    }
    Estimate lost = estimate(BOTH, LOSES, 0);
    assertEquals(LOST, lost.value(), 4 * 0.023);
    assertEquals(0.023 * IntervalWidths.own().threshold(), lost.deviation(), 0.01);
  }

  /** Three values of another effect stand before it. */
  @Test
  void value_isTakenFromBehindTheOthers() {
    Hypothesis others = Worlds.effect(Effect.CROSSTALK, "any", 0.01, 0.5, 2).and(LOSES, LOST);
    Estimate shift = estimate(others.and(SHIFTS, OFFSET_M), SHIFTS, OFFSET_M);
    assertEquals(OFFSET_M, shift.value(), 0.003);
    assertTrue(shift.deviation() < 0.002, shift::toString);
  }

  /** From far away no search finds half a metre; where it was found it is known. */
  @Test
  void value_isKeptWhereItWasFound() {
    Hypothesis far = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.5);
    DataSet data =
        new DataSet(
            "post", Worlds.POST, Worlds.read(Worlds.poses(200, 0.3, 1.3, 3), far, 4), List.of());
    Estimate shift = new Heard(data, found(far)).estimate(SHIFTS, -0.8);
    assertEquals(0.5, shift.value(), 0.003);
    assertTrue(shift.deviation() < 0.002, shift::toString);
  }

  @Test
  void with_putsTheValueInItsPlace() {
    Hypothesis with = Heard.with(BOTH, LOSES, 0.2);
    assertEquals(List.of(LOSES, SHIFTS), with.forms());
    assertEquals(Worlds.effect(Effect.DROPOUT, "single", 0.2).and(SHIFTS, OFFSET_M), with);
  }

  @Test
  void with_addsWhatIsNew() {
    assertEquals(BOTH, Heard.with(DROPOUT, SHIFTS, OFFSET_M));
    assertEquals(DROPOUT, Heard.with(Hypothesis.NONE, LOSES, LOST));
  }

  /** Two forms of one effect do not stand beside each other. */
  @Test
  void with_takesAwayOtherFormsOfTheEffect() {
    Hypothesis growing = Worlds.effect(Effect.DROPOUT, "bursts", 0.1, 5).and(SHIFTS, OFFSET_M);
    assertEquals(
        Worlds.effect(Effect.RANGE_OFFSET, "constant", OFFSET_M).and(LOSES, LOST),
        Heard.with(growing, LOSES, LOST));
  }

  /** Half of what a user would mind: no difference below it is worth two causes. */
  @Test
  void immaterial_isHalfOfThePracticalSize() {
    JointWorld world = new JointWorld(8);
    world.runs = 1;
    world.drive();
    Robot robot = world.motion().robot();
    for (Counterpart one : Counterpart.all(world.data(), robot)) {
      assertTrue(one.immaterial() > 0);
      assertEquals(
          one.moves().parameters().get(0).practical(), 2 * one.immaterial(), 1e-15, one.toString());
    }
  }
}
