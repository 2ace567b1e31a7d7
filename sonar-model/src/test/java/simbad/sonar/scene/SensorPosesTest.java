package simbad.sonar.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

class SensorPosesTest {
  private static final Outline BOX =
      Outline.of(List.of(new Point(-0.1, -0.2), new Point(0.1, -0.2), new Point(0, 0.3)));
  private static final SonarSpec SONAR =
      new SonarSpec("S", 0.3, 0, 4, 0.2, 343, 0, 0.01, 0, 0.01, 0.05);

  private static SensingSetup setup(Map<String, Placement> mounts, Placement... obstacles) {
    List<Obstacle> all =
        List.of(obstacles).stream()
            .map(place -> new Obstacle("box", place, BOX, new UniformDetection(4)))
            .toList();
    return new SensingSetup(
        SONAR, new Scene(all), 4, new SetupDetails(0, 0, mounts, Optional.empty(), List.of()));
  }

  private static ReadingRow row(String sensor, Pose pose, MovedObstacle obstacle) {
    return new ReadingRow(
        "r", sensor, 0, pose, new Echo(1), Circumstances.NONE.withObstacle(obstacle));
  }

  private static ReadingRow only(SensingSetup setup, ReadingRow row) {
    assertEquals(Optional.empty(), SensorPoses.problem(setup, List.of(row)));
    return SensorPoses.of(setup, List.of(row)).get(0);
  }

  /** Distance, bearing and off-axis angle are what they were, whatever was moved. */
  @Property
  void movedObstacle_isAsFarAndOnTheSameSide(
      @ForAll @DoubleRange(min = -2, max = 2) double x,
      @ForAll @DoubleRange(min = -2, max = 2) double z,
      @ForAll @DoubleRange(min = -6, max = 6) double turn,
      @ForAll @DoubleRange(min = -3, max = 3) double heading) {
    Placement scenes = new Placement(0.3, -0.4, 0.5);
    Placement then = new Placement(x, z, turn);
    Pose sensor = Pose.of(1.5, 2.5, heading);
    MovedObstacle moved =
        new MovedObstacle(OptionalDouble.of(x), OptionalDouble.of(z), OptionalDouble.of(turn));
    ReadingRow seen = only(setup(Map.of(), scenes), row("s", sensor, moved));
    Point place = seen.pose().position();
    assertEquals(
        then.centreDistanceM(1.5, 2.5), scenes.centreDistanceM(place.xM(), place.zM()), 1e-9);
    double bearing = scenes.bearingRad(place.xM(), place.zM()) - then.bearingRad(1.5, 2.5);
    assertEquals(0, Math.sin(bearing / 2), 1e-9);
    double offAxis =
        sensor.offAxisRad(new Point(x, z)) - seen.pose().offAxisRad(new Point(0.3, -0.4));
    assertEquals(0, Math.sin(offAxis / 2), 1e-9);
    assertEquals(MovedObstacle.UNMOVED, seen.circumstances().obstacle());
  }

  /** A target turned clockwise by 30 degrees shows the sensor the side 30 degrees to the left. */
  @Test
  void turnedTarget_turnsTheBearing() {
    MovedObstacle turned =
        new MovedObstacle(
            OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.of(Math.toRadians(-30)));
    ReadingRow seen =
        only(setup(Map.of(), Placement.IDENTITY), row("s", Pose.of(0, 1, Math.PI / 2), turned));
    Point place = seen.pose().position();
    assertEquals(30, Math.toDegrees(Placement.IDENTITY.bearingRad(place.xM(), place.zM())), 1e-9);
  }

  /** Robot at (1, 2) looking up the page: forward is -z, its left is -x. */
  @Test
  void mount_isSeenFromTheRobot() {
    Map<String, Placement> mounts = Map.of("left", new Placement(0.1, -0.05, Math.PI / 2));
    ReadingRow seen =
        only(
            setup(mounts, Placement.IDENTITY),
            row("left", Pose.of(1, 2, Math.PI / 2), MovedObstacle.UNMOVED));
    assertEquals(0.95, seen.pose().position().xM(), 1e-12);
    assertEquals(1.9, seen.pose().position().zM(), 1e-12);
    assertEquals(Math.PI, Math.abs(seen.pose().heading().radians()), 1e-12);
    Pose robot = SensorPoses.undone(setup(mounts, Placement.IDENTITY), List.of(seen)).get(0).pose();
    assertEquals(0, robot.position().distanceM(new Point(1, 2)), 1e-12);
    assertEquals(Math.PI / 2, robot.heading().radians(), 1e-12);
  }

  @Test
  void plainRow_isLeftAlone() {
    ReadingRow row = row("s", Pose.of(1, 2, 3), MovedObstacle.UNMOVED);
    assertSame(row, only(setup(Map.of(), Placement.IDENTITY, new Placement(3, 3, 0)), row));
  }

  @Test
  void problems_areSaid() {
    MovedObstacle moved =
        new MovedObstacle(OptionalDouble.of(1), OptionalDouble.empty(), OptionalDouble.empty());
    List<ReadingRow> rows = List.of(row("s", Pose.of(0, 0, 0), moved));
    SensingSetup two = setup(Map.of(), Placement.IDENTITY, new Placement(3, 3, 0));
    assertTrue(SensorPoses.problem(two, rows).orElseThrow().contains("a scene with one obstacle"));
    SensingSetup mounted = setup(Map.of("left", Placement.IDENTITY), Placement.IDENTITY);
    assertTrue(
        SensorPoses.problem(mounted, rows).orElseThrow().contains("'s' has no mount in the scene"));
  }
}
