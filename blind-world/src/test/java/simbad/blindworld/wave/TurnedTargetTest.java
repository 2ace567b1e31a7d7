package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/** What symmetry says of an echo. */
class TurnedTargetTest {

  private static final Air AIR = new Air(20, 50, 101.325);

  private static Medium medium(double receiverAxisRad) {
    Burst.Resonance wide = new Burst.Resonance(40_000, 3);
    return new Medium(
        new Gear(
            new Burst(40_000, 8, wide, wide, 0),
            new Gear.Pistons(0.008, 0.007, 0.05, receiverAxisRad),
            new Gear.Receiver(1, 1, 1, 0, 0.03, 0.01),
            0),
        AIR);
  }

  private static Outline strip() {
    return Outline.of(
        List.of(
            new Point(-0.06, -0.01),
            new Point(0.06, -0.01),
            new Point(0.05, 0.02),
            new Point(-0.06, 0.01)));
  }

  private static double most(double turnRad, double shiftM, double atRad) {
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    // The sonar at 1 m to the left of the target looks 0.2 rad beside it.
    Pose pose = new Pose(shiftM - cos + 0.1 * sin, sin + 0.1 * cos, turnRad + 0.2);
    Target target =
        new Target(strip(), new Upright(-0.15, 0.5), new Point(shiftM, 0), atRad + turnRad);
    return target.arrivals(pose, medium(0.1), 0).most();
  }

  /** A room that is turned and moved as a whole sounds the same. */
  @ParameterizedTest
  @ValueSource(doubles = {0.4, 1.7, -2.5})
  void turnedRoom_soundsTheSame(double turnRad) {
    for (double at : new double[] {0, 0.6, 2}) {
      double straight = most(0, 0, at);
      assertEquals(straight, most(turnRad, 0.7, at), 1e-6 * straight);
    }
    assertTrue(Math.abs(most(0, 0, 0) / most(0, 0, 0.6) - 1) > 0.05, "its side counts");
  }

  /** By a board an echo goes either way round, and both ways are as long. */
  @Test
  void mirroredEcho_goesBothWays() {
    Target pole = new Target(Outline.round(0.03), Upright.ENDLESS, new Point(1, 0), 0);
    Point from = new Point(0, 0.5);
    Point to = new Point(1, 0.5);
    Burst.Resonance wide = new Burst.Resonance(40_000, 3);
    Medium medium =
        new Medium(
            new Gear(
                new Burst(40_000, 8, wide, wide, 0),
                new Gear.Pistons(0.003, 0.003, 0, 0),
                new Gear.Receiver(1, 1, 1, 0, 0.03, 0.01),
                0),
            AIR);
    Listener here = Listener.at(new Pose(0, 0, 0), 0);
    Listener behind = here.mirrored(new Outline.Face(from, to));
    double once = pole.between(here, behind, medium).most();
    double both = new Mirrored(pole, from, to).arrivals(new Pose(0, 0, 0), medium, 0).most();
    assertEquals(2 * once, both, 0.01 * once);
  }
}
