package simbad.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.FollowerRobot;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.Start;
import simbad.gui.Simbatch;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;

/**
 * A world that is stepped as far as somebody looks, and remembers what was. The first robot is that
 * of {@code simbad run}: without moves by hand its places are those of the run's trace. Further
 * ones start on bearings between, as far out; robots do not hear each other. Safe for use by
 * several threads, which wait for each other.
 */
final class LiveWorld {
  /** 50 minutes of the robot's time. */
  static final int MOST_STEPS = 60_000;

  /** In one answer. */
  static final int MOST_FRAMES = 2000;

  /** Steps that one answer may take at most, however few of them it shows. */
  static final int MOST_STEPS_AT_ONCE = 20_000;

  private final List<Move> moves;
  private final List<FollowerRobot> robots = new ArrayList<>();
  private final List<RangeSensorBelt> belts = new ArrayList<>();
  private final SonarObstacle obstacle;
  private final Reasons reasons;
  private final Simbatch simulation;
  private final Recorded film;
  private final Point3d place = new Point3d();
  private Placement standing = Placement.IDENTITY;
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
    obstacle = new SonarObstacle(new Vector3d(), 0, type);
    reasons = new Reasons(sensor, sonar, type);
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.add(obstacle);
    Point first = scene.start().orElse(Start.standard(type, sonar).position());
    for (int i = 0; i < scene.robots(); i++) {
      Optional<Point> start =
          i == 0 ? scene.start() : Optional.of(turned(first, i * Angles.TURN_RAD / scene.robots()));
      Circuit circuit =
          new Circuit(type, List.of(), driven, sonar, scene.speedMPerS(), start, scene.seed() + i);
      FollowerRobot robot =
          circuit.robot(new EdgeFollower(Tuning.standard(scene.speedMPerS(), Circuit.STEP_S)));
      robots.add(robot);
      belts.add((RangeSensorBelt) robot.getSensorDevice(0));
      environment.add(robot);
    }
    film = new Recorded(scene.robots(), angles(belts.get(0)));
    simulation = new Simbatch(environment, false);
    simulation.reset();
  }

  private static Point turned(Point at, double turnRad) {
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    return new Point(at.xM() * cos + at.zM() * sin, at.zM() * cos - at.xM() * sin);
  }

  private static double[] angles(RangeSensorBelt belt) {
    return IntStream.range(0, belt.getNumSensors()).mapToDouble(belt::getSensorAngle).toArray();
  }

  /**
   * Returns what was seen before some steps, as a JSON list; steps as far as that needs.
   *
   * @param from first of them, at least 0
   * @param count of them; {@value #MOST_FRAMES} at most are given
   * @param every how many steps lie between two of them, at least 1
   */
  synchronized String frames(int from, int count, int every) {
    // Further ahead than that nobody looks: an answer costs so much at most.
    int ahead =
        Math.min(MOST_STEPS, film.size() + Math.min(2 * MOST_FRAMES * every, MOST_STEPS_AT_ONCE));
    long last = from + (Math.min(count, MOST_FRAMES) - 1L) * every;
    int end = (int) Math.min(ahead, last + 1);
    while (film.size() < end) {
      step();
    }
    StringBuilder text = new StringBuilder("[");
    for (int step = from; step < end; step += every) {
      film.write(text.append(step == from ? "" : ",\n"), step, reasons);
    }
    return text.append(']').toString();
  }

  private void step() {
    while (nextMove < moves.size() && moves.get(nextMove).step() <= film.size()) {
      apply(moves.get(nextMove++));
    }
    film.begin(standing);
    for (FollowerRobot robot : robots) {
      robot.getCoords(place);
      film.pose(place.x, place.z, robot.getHeadingRad());
    }
    simulation.step();
    for (int i = 0; i < belts.size(); i++) {
      Readings readings = belts.get(i).getReadings();
      for (int sonar = 0; sonar < readings.size(); sonar++) {
        film.range(i, sonar, readings.isEcho(sonar) ? readings.rangeM(sonar) : -1);
      }
    }
  }

  private void apply(Move move) {
    if (move.thing() == Move.Thing.ROBOT) {
      robots.get(move.number()).moveToPosition(move.xM(), move.zM());
      return;
    }
    Placement at = obstacle.worldFromObstacle();
    obstacle.translateTo(new Vector3d(move.xM() - at.xM(), 0, move.zM() - at.zM()));
    obstacle.rotateY(move.turnRad() - at.turnRad());
    standing = obstacle.worldFromObstacle();
  }

  synchronized void dispose() {
    simulation.dispose();
  }
}
