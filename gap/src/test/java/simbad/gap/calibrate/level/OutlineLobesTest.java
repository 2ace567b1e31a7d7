package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.ping.NearField;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** A strip of 5 cm, 6 waves wide: the lobe of its face is narrower than a table's 5 degrees. */
class OutlineLobesTest {
  private static final int POINTS = 72;
  private static final double FACE_DB = 30;
  private static final double NONE_DB = -6;

  private static final NearField STRIP =
      new NearField(
          new Obstacle(
              "strip",
              Placement.IDENTITY,
              Outline.of(
                  List.of(
                      new Point(-0.025, -0.001),
                      new Point(-0.025, 0.001),
                      new Point(0.025, 0.001),
                      new Point(0.025, -0.001))),
              new UniformDetection(2)),
          2 * Math.PI * 40_000 / 343);

  private static OutlineLobes lobes(IntPredicate tells) {
    return new OutlineLobes(STRIP, POINTS, tells, i -> FACE_DB);
  }

  /** Half a step beside the face the echo has not yet fallen by half of what it falls by. */
  @Test
  void betweenItsBearings_aLobeIsNoStraightLine() {
    OutlineLobes lobes = lobes(i -> true);
    assertEquals(3, lobes.aboveLineDb(0.5), 0);
    assertEquals(lobes.aboveLineDb(0.5), lobes.aboveLineDb(POINTS - 0.5), 1e-6);
    for (int point = 0; point < POINTS; point++) {
      assertEquals(0, lobes.aboveLineDb(point), 1e-9);
      assertTrue(Math.abs(lobes.aboveLineDb(point + 0.3)) <= 3);
    }
  }

  /** Its face shows how strong it is; of its edge the table says "weak" only. */
  @Test
  void whereATableSaysWeak_theOutlineSaysHowWeak() {
    OutlineLobes lobes = lobes(i -> i == 0);
    double apart = STRIP.believedDb(Math.toRadians(40)) - STRIP.believedDb(0);
    assertEquals(apart + 25, lobes.weakerDb(8, FACE_DB - 25, NONE_DB), 1e-9);
    assertEquals(-10, lobes.weakerDb(8, FACE_DB, NONE_DB), 0);
    assertEquals(0, lobes.weakerDb(0, FACE_DB - 25, NONE_DB), 0);
    assertEquals(NONE_DB, lobes(i -> false).weakerDb(8, FACE_DB, NONE_DB), 0);
  }
}
