package simbad.gap.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Estimate;

/** What is said of a cause that may show in both halves. */
class SharedTest {
  /** 1.96 of 0.001 to either side: 1.04804 and 1.05196. */
  private static final String KNOWN = "1.0500, 95 % interval 1.0480 to 1.0520";

  private static final Estimate VALUE = new Estimate(1.05, 0.001);
  private static final Estimate OPEN = new Estimate(1, Double.POSITIVE_INFINITY);

  private static Shared of(
      boolean tracked, boolean heard, Estimate byTrack, Estimate byEcho, boolean one) {
    return new Shared(
        "wheel-scale", Effect.ODOMETRY_SCALE, "factor", tracked, heard, byTrack, byEcho, one);
  }

  @Test
  void oneCause_hasTheValueOfBothTogether() {
    Shared both = of(true, true, new Estimate(1, 0.1), new Estimate(2, 0.1), true);
    assertEquals(1.5, both.together().value(), 1e-12);
    assertEquals(0.1 / Math.sqrt(2), both.together().deviation(), 1e-12);
  }

  @Test
  void oneCause_isSaidWithWhoShowsIt() {
    assertEquals(
        "wheel-scale is one cause, seen by the tracker and heard by the sonar (as odometry-scale):"
            + " factor = "
            + KNOWN,
        of(true, true, VALUE, OPEN, true).words());
    assertEquals(
        "wheel-scale is one cause, seen by the tracker; the readings neither confirm nor exclude"
            + " it: factor = "
            + KNOWN,
        of(true, false, VALUE, OPEN, true).words());
    assertEquals(
        "wheel-scale is one cause, heard by the sonar (as odometry-scale); the track neither"
            + " confirms nor excludes it: factor = "
            + KNOWN,
        of(false, true, OPEN, VALUE, true).words());
  }

  @Test
  void twoCauses_areSaidByWhereItShows() {
    assertEquals(
        "wheel-scale is seen by the tracker ("
            + KNOWN
            + ") and not heard in the poses that the robot reckoned (open): the robot knows how far"
            + " it goes, but the drive does not do what it is told",
        of(true, false, VALUE, OPEN, false).words());
    assertEquals(
        "odometry-scale is heard by the sonar ("
            + KNOWN
            + ") and not seen by the tracker (open): the robot goes as it is told, but it reckons"
            + " its poses wrongly",
        of(false, true, OPEN, VALUE, false).words());
  }

  @Test
  void whereNobodyKnows_theValueIsOpen() {
    String words = of(true, true, OPEN, OPEN, true).words();
    assertTrue(words.endsWith("factor = open"), words);
  }
}
