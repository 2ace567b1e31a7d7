package simbad.experiments.fleet;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.experiments.motion.DiagnosedKinematic;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.FollowerRobot;
import simbad.gui.Simbatch;
import simbad.obstacles.SonarObstacle;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.sensing.Readings;

/**
 * One robot with a belt, alone with its obstacles. A step moves first and senses then, so that the
 * readings are those after the command; the stations of both are the simulator's.
 */
final class FleetRobot extends Agent {
  private static final double CLEARANCE_M = 0.005;
  private static final int TRIES = 10_000;

  private final FleetSetup setup;
  private final RangeSensorBelt belt;
  private final Chance chance = new Chance();
  private final Point3d place = new Point3d();
  private SplittableRandom episodes = new SplittableRandom(0);
  private int steps;

  FleetRobot(FleetSetup setup) {
    super(new Vector3d(), "robot");
    radius = FollowerRobot.RADIUS_M;
    height = FollowerRobot.HEIGHT_M;
    this.setup = setup;
    belt = setup.sensor().belt(setup.sonar(), chance);
    belt.setUpdateOnEachFrame(true);
    double aboveMiddleM = setup.sonar().mountHeightM() - height / 2.0;
    addSensorDevice(belt, new Vector3d(0, aboveMiddleM, 0), 0);
    setup
        .sensor()
        .robot()
        .ifPresent(kind -> setKinematicModel(new DiagnosedKinematic(kind.motion())));
    enterWorld();
  }

  private void enterWorld() {
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.add(new SonarObstacle(new Vector3d(), 0, setup.circled()));
    setup
        .around()
        .forEach(
            other -> {
              Placement at = other.placement();
              environment.add(
                  new SonarObstacle(new Vector3d(at.xM(), 0, at.zM()), at.turnRad(), other.type()));
            });
    environment.add(this);
    // Puts the robot into the world; it is stepped by itself from then on.
    new Simbatch(environment, false).reset();
  }

  /** Lets all chance begin anew. */
  void seed(long seed) {
    episodes = new SplittableRandom(seed);
  }

  /** Begins an episode at a free place, by chance between the obstacle and the farthest edge. */
  void start() {
    double nearM = setup.circled().outline().reachM(0, 0) + radius + CLEARANCE_M;
    double edgeM =
        Math.min(setup.circled().thresholds().table().greatestM(), DetectionRule.ORIGINAL_RANGE_M);
    double farM = Math.max(nearM, edgeM);
    chance.take(episodes.split());
    for (int i = 0; i < TRIES; i++) {
      double bearing = episodes.nextDouble() * Angles.TURN_RAD;
      double distanceM = nearM + episodes.nextDouble() * (farM - nearM);
      double headingRad = (episodes.nextDouble() - 0.5) * Angles.TURN_RAD;
      place(distanceM * Math.sin(bearing), distanceM * Math.cos(bearing), headingRad);
      if (isFree()) {
        updateSensors(Circuit.STEP_S, null);
        return;
      }
    }
    throw new IllegalStateException(
        "no free place to start was found round " + setup.circled().name());
  }

  /** Begins an episode at a place, metres and radians. */
  void startAt(double xM, double zM, double headingRad) {
    chance.take(episodes.split());
    place(xM, zM, headingRad);
    updateSensors(Circuit.STEP_S, null);
  }

  private void place(double xM, double zM, double headingRad) {
    steps = 0;
    reset();
    setPose(xM, zM, headingRad);
  }

  private boolean isFree() {
    instantTranslation.set(0, 0, 0);
    checkCollision(null, false);
    return !collisionDetected();
  }

  /**
   * Moves for one step and senses.
   *
   * @param speedMPerS ahead
   * @param turnRadPerS counter-clockwise
   */
  void step(double speedMPerS, double turnRadPerS) {
    setTranslationalVelocity(speedMPerS);
    setRotationalVelocity(turnRadPerS);
    setMotorsAcceleration(Circuit.STEP_S);
    integratesVelocities(Circuit.STEP_S);
    integratesPositionChange(Circuit.STEP_S);
    checkCollision(null, false);
    updatePosition();
    updateCounters(Circuit.STEP_S);
    updateSensors(Circuit.STEP_S, null);
    steps++;
    getCoords(place);
  }

  /** Returns whether an obstacle stopped it in this step. */
  boolean isStoppedByObstacle() {
    return collisionDetected();
  }

  /** Returns whether the episode is as long as it may be. */
  boolean isAtItsEnd() {
    return steps >= setup.mostSteps();
  }

  Readings readings() {
    return belt.getReadings();
  }

  double xM() {
    getCoords(place);
    return place.x;
  }

  double zM() {
    getCoords(place);
    return place.z;
  }

  /** A source of chance that a belt keeps while each episode brings its own numbers. */
  private static final class Chance implements RandomGenerator {
    private SplittableRandom source = new SplittableRandom(0);

    void take(SplittableRandom newSource) {
      source = newSource;
    }

    @Override
    public long nextLong() {
      return source.nextLong();
    }
  }
}
