package simbad.experiments.run;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.experiments.control.Controller;
import simbad.experiments.motion.DiagnosedKinematic;
import simbad.gui.Simbatch;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * What one robot shall do: once round an obstacle, by what a sensor says.
 *
 * @param type of the obstacle, which stands at the origin
 * @param around what else stands there
 * @param sensor of the robot
 * @param sonar figures of the sensor
 * @param speedMPerS of the robot, in (0, {@value RunSettings#GREATEST_SPEED_M_PER_S}]
 * @param start where the robot starts; by default on the bearing of the greatest threshold,
 *     half-way out
 * @param seed of all chance
 */
public record Circuit(
    ObstacleType type,
    List<Neighbour> around,
    SensorKind sensor,
    SonarSpec sonar,
    double speedMPerS,
    Optional<Point> start,
    long seed) {
  /** The simulator's step, seconds. */
  public static final double STEP_S = 0.05;

  /** Copies the list and checks the speed. */
  public Circuit {
    around = List.copyOf(around);
    RunSettings.requireSpeed(speedMPerS);
  }

  /** One of the circuits of a run. */
  static Circuit of(ObstacleType type, SensorKind sensor, RunSettings settings) {
    return new Circuit(
        type,
        List.of(),
        sensor,
        settings.sonar(),
        settings.speedMPerS(),
        settings.start(),
        settings.seed());
  }

  /**
   * Drives the robot until it is once round, or stuck, or lost.
   *
   * @param controller that has read nothing yet
   * @return where the robot was
   */
  public Trace drive(Controller controller) {
    return drive(controller, Pace.AT_ONCE, false);
  }

  /**
   * Does the same with a robot that is given time.
   *
   * @param controller that has read nothing yet
   * @param pace how much time the robot is given for each decision
   * @param keepsReadings whether the trace shall have what the belt read
   */
  public Trace drive(Controller controller, Pace pace, boolean keepsReadings) {
    return new Drive(this, pace.of(controller), keepsReadings).drive(pace.mostSteps());
  }

  /**
   * Returns the robot that {@link #drive} drives, at its start, to be stepped by who looks on.
   *
   * @param controller that has read nothing yet
   */
  public FollowerRobot robot(Controller controller) {
    SplittableRandom random = new SplittableRandom(seed(type, sensor, seed));
    RangeSensorBelt belt = sensor.belt(sonar, random);
    FollowerRobot follower = new FollowerRobot(startPose(), belt, sonar.mountHeightM(), controller);
    sensor.robot().ifPresent(kind -> follower.movesBy(new DiagnosedKinematic(kind.motion())));
    return follower;
  }

  private Pose startPose() {
    return start.map(Start::lookingInwards).orElseGet(() -> Start.standard(type, sonar));
  }

  /**
   * Every run has chance of its own, so that none depends on which others are made. A robot that
   * moves otherwise hears with the same chance, for the two to be compared.
   */
  static long seed(ObstacleType type, SensorKind sensor, long seed) {
    return seed * 1_000_003L + 31L * type.name().hashCode() + sensor.hearing().hashCode();
  }

  /** Compares a trace of this circuit with the obstacle's table. */
  public TraceErrors errors(Trace trace) {
    return TraceErrors.of(trace, type.thresholds().table());
  }

  /** One robot round one obstacle with one sensor, as it drives. */
  private static final class Drive {
    /** The robot is given up after so many times the steps that the edge itself takes. */
    private static final int PATIENCE = 30;

    /** Silent steps after which the edge counts as found. */
    private static final int LOST_AFTER = 3;

    /** A robot that is not moved for so many steps is blocked for good. */
    private static final int BLOCKED_AFTER = 1000;

    private final Circuit circuit;
    private final boolean keepsReadings;
    private final FollowerRobot robot;
    private final Simbatch simulation;
    private final Trace trace = new Trace(Circuit.STEP_S);
    private final Point3d place = new Point3d();
    private final Point3d pinged = new Point3d();
    private boolean everHeard;
    private int silent;
    private int still;
    private double woundRad;
    private double bearingRad;

    Drive(Circuit circuit, Controller controller, boolean keepsReadings) {
      this.circuit = circuit;
      this.keepsReadings = keepsReadings;
      robot = circuit.robot(controller);
      EnvironmentDescription environment = new EnvironmentDescription();
      environment.add(new SonarObstacle(new Vector3d(), 0, circuit.type()));
      for (Neighbour neighbour : circuit.around()) {
        Placement at = neighbour.placement();
        environment.add(
            new SonarObstacle(new Vector3d(at.xM(), 0, at.zM()), at.turnRad(), neighbour.type()));
      }
      environment.add(robot);
      simulation = new Simbatch(environment, false);
    }

    Trace drive(int times) {
      simulation.reset();
      long most = times * mostSteps();
      double farthestM = farthestM();
      while (!trace.isClosed()
          && trace.size() < most
          && still < BLOCKED_AFTER
          && Math.hypot(place.x, place.z) <= farthestM) {
        robot.getCoords(pinged);
        double pingedRad = robot.getHeadingRad();
        simulation.step();
        if (keepsReadings) {
          keepReadings(pingedRad);
        }
        double fromX = place.x;
        double fromZ = place.z;
        robot.getCoords(place);
        still = place.x == fromX && place.z == fromZ ? still + 1 : 0;
        trace.add(place.x, place.z, robot.getHeadingRad(), robot.hears());
        observe();
      }
      simulation.dispose();
      return trace;
    }

    /** The belt pings before the robot moves: of each sonar where it was then. */
    private void keepReadings(double headingRad) {
      double timeS = trace.size() * Circuit.STEP_S;
      RangeSensorBelt belt = robot.belt();
      for (int i = 0; i < belt.getNumSensors(); i++) {
        Pose pose = Pose.of(pinged.x, pinged.z, headingRad + belt.getSensorAngle(i));
        trace.read(new ReadingRow("run", "sonar-" + i, timeS, pose, belt.getReadings().reading(i)));
      }
    }

    private long mostSteps() {
      ThresholdTable table = circuit.type().thresholds().table();
      double edgeM = table.greatestM() > 0 ? Outline.of(table.points()).perimeterM() : 0;
      double wayM = Math.max(edgeM, Angles.TURN_RAD * DetectionRule.ORIGINAL_RANGE_M);
      return (long) (PATIENCE * wayM / (circuit.speedMPerS() * Circuit.STEP_S));
    }

    /** Further out nothing can be heard: the robot is lost. */
    private double farthestM() {
      double heardM =
          Math.max(circuit.type().thresholds().table().greatestM(), DetectionRule.ORIGINAL_RANGE_M);
      double startM = circuit.start().map(p -> Math.hypot(p.xM(), p.zM())).orElse(0.0);
      return Math.max(2 * heardM + circuit.sonar().maxRangeM(), startM) + 1;
    }

    private void observe() {
      everHeard |= robot.hears();
      silent = robot.hears() ? 0 : silent + 1;
      double bearing = Math.atan2(place.x, place.z);
      if (trace.firstOnEdge() < trace.size()) {
        woundRad += Angles.signed(bearing - bearingRad);
        if (Math.abs(woundRad) >= Angles.TURN_RAD) {
          trace.close();
        }
      } else if (everHeard && silent == LOST_AFTER) {
        trace.edgeFound();
      }
      bearingRad = bearing;
    }
  }
}
