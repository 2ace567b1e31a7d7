package simbad.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.FollowerRobot;
import simbad.experiments.run.SensorKind;
import simbad.gui.Simbatch;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;

/**
 * A world that is stepped as far as somebody looks, and remembers what was. The robot is that of
 * {@code simbad run}: without moves by hand its places are those of the run's trace. Safe for use
 * by several threads, which wait for each other.
 */
final class LiveWorld {
  /** 50 minutes of the robot's time. */
  static final int MOST_STEPS = 60_000;

  /** In one answer. */
  static final int MOST_FRAMES = 2000;

  private final List<Move> moves;
  private final FollowerRobot robot;
  private final RangeSensorBelt belt;
  private final SonarObstacle obstacle;
  private final Reasons reasons;
  private final Simbatch simulation;
  private final List<String> frames = new ArrayList<>();
  private final Point3d place = new Point3d();
  private int nextMove;

  /**
   * Creates the world at rest.
   *
   * @param scene its obstacle and sensor are the next two
   * @param driven the sensor on its robot
   * @param sonar figures of the sensor
   */
  LiveWorld(
      StudioScene scene, ObstacleType type, SensorKind sensor, SensorKind driven, SonarSpec sonar) {
    moves = scene.moves();
    Circuit circuit =
        new Circuit(
            type, List.of(), driven, sonar, scene.speedMPerS(), scene.start(), scene.seed());
    robot = circuit.robot(new EdgeFollower(Tuning.standard(scene.speedMPerS(), Circuit.STEP_S)));
    belt = (RangeSensorBelt) robot.getSensorDevice(0);
    obstacle = new SonarObstacle(new Vector3d(), 0, type);
    reasons = new Reasons(sensor, sonar, type);
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.add(obstacle);
    environment.add(robot);
    simulation = new Simbatch(environment, false);
    simulation.reset();
  }

  /**
   * Returns what was seen before some steps, as a JSON list; steps as far as that needs.
   *
   * @param from first of them, at least 0
   * @param count of them; {@value #MOST_FRAMES} at most are given
   */
  synchronized String frames(int from, int count) {
    // Further ahead than that nobody looks: an answer costs so much at most.
    int ahead = Math.min(MOST_STEPS, frames.size() + 2 * MOST_FRAMES);
    int end = Math.min(ahead, from + Math.min(count, MOST_FRAMES));
    while (frames.size() < end) {
      step();
    }
    return "[" + String.join(",\n", frames.subList(Math.min(from, end), end)) + "]";
  }

  private void step() {
    while (nextMove < moves.size() && moves.get(nextMove).step() <= frames.size()) {
      apply(moves.get(nextMove++));
    }
    robot.getCoords(place);
    Pose pose = Pose.of(place.x, place.z, robot.getHeadingRad());
    simulation.step();
    frames.add(frame(pose));
  }

  private void apply(Move move) {
    if (move.thing() == Move.Thing.ROBOT) {
      robot.moveToPosition(move.xM(), move.zM());
      return;
    }
    Placement at = obstacle.worldFromObstacle();
    obstacle.translateTo(new Vector3d(move.xM() - at.xM(), 0, move.zM() - at.zM()));
    obstacle.rotateY(move.turnRad() - at.turnRad());
    reasons.obstacleAt(obstacle.worldFromObstacle());
  }

  /** x, z, heading, the obstacle's x, z and turn, ranges in mm or -1, reasons. */
  private String frame(Pose pose) {
    Placement at = obstacle.worldFromObstacle();
    StringBuilder text = new StringBuilder(160);
    text.append(
        String.format(
            Locale.ROOT,
            "[%.4f,%.4f,%.4f,%.3f,%.3f,%.4f",
            pose.position().xM(),
            pose.position().zM(),
            pose.heading().radians(),
            at.xM(),
            at.zM(),
            at.turnRad()));
    Readings readings = belt.getReadings();
    for (int i = 0; i < readings.size(); i++) {
      text.append(',').append(readings.isEcho(i) ? Math.round(1000 * readings.rangeM(i)) : -1);
    }
    for (int i = 0; i < readings.size(); i++) {
      text.append(',').append(readings.isEcho(i) ? Reasons.HEARD : reasons.of(sonar(pose, i)));
    }
    return text.append(']').toString();
  }

  private Pose sonar(Pose pose, int index) {
    return Pose.of(
        pose.position().xM(),
        pose.position().zM(),
        pose.heading().radians() + belt.getSensorAngle(index));
  }

  synchronized void dispose() {
    simulation.dispose();
  }
}
