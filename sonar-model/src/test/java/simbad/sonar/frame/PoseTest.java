package simbad.sonar.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.jqwik.api.ForAll;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;

class PoseTest {
  /** On paper z points down: heading 90 looks up the page, its left is -x. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 0, 0",
    "0, 1, -1, 45",
    "0, 0, -1, 90",
    "0, -1, 0, 180",
    "0, 0, 1, -90",
    "90, 0, -1, 0",
    "90, -1, -1, 45",
    "90, 1, -1, -45",
    "180, -1, 0, 0",
    "-90, 0, 5, 0",
    "135, -1, 0, 45",
    "-135, -1, 0, -45"
  })
  void offAxisAngle_isPositiveCounterClockwise(double heading, double x, double z, double off) {
    Pose pose = Pose.of(3, -2, Math.toRadians(heading));
    assertEquals(off, Math.toDegrees(pose.offAxisRad(new Point(3 + x, -2 + z))), 1e-6);
  }

  @Test
  void offAxisAngle_ofItsOwnPlace_isZero() {
    assertEquals(0, Pose.of(1, 2, 3).offAxisRad(new Point(1, 2)));
  }

  @Seeded
  void offAxisAngle_growsByWhatTheHeadingLoses(
      @ForAll @DoubleRange(min = -3, max = 3) double heading,
      @ForAll @DoubleRange(min = -3, max = 3) double more) {
    Point point = new Point(0.3, -1.7);
    double before = Pose.of(1, 1, heading).offAxisRad(point);
    double after = Pose.of(1, 1, heading + more).offAxisRad(point);
    assertEquals(0, Angles.signed(before - more - after), 1e-12);
  }

  @Test
  void distance_isPythagoras() {
    assertEquals(5, new Point(1, 1).distanceM(new Point(4, -3)), 1e-15);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void places_notFinite_areRefused(double bad) {
    Refusal.check(() -> new Point(bad, 0), "xM = " + bad, "not finite");
    Refusal.check(() -> new Point(0, bad), "zM = " + bad, "not finite");
    Refusal.check(() -> new Placement(bad, 0, 0), "xM = " + bad, "not finite");
    Refusal.check(() -> new Placement(0, bad, 0), "zM = " + bad, "not finite");
    Refusal.check(() -> new Placement(0, 0, bad), "turnRad = " + bad, "not finite");
    Refusal.check(() -> Pose.of(0, bad, 0), "zM = " + bad);
  }
}
