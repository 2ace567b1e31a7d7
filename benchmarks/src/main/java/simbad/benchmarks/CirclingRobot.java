package simbad.benchmarks;

import java.util.Optional;
import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.frame.Point;

/** A robot that drives round and round a small circle, whatever its sonars say. */
final class CirclingRobot extends Agent {
  private static final double TURN_RATE_RAD_PER_S = 0.5;

  private final Optional<RangeSensorBelt> belt;

  /**
   * Creates a robot.
   *
   * @param centre of its circle
   * @param kind what its sonars hear, if it senses at all
   * @param sonars how many it has
   * @param sensing how often it senses
   */
  CirclingRobot(Point centre, Belt kind, int sonars, Sensing sensing) {
    // It starts on the near side, looks along +x and turns left: -z is on the left.
    super(new Vector3d(centre.xM(), 0, centre.zM() + Circle.RADIUS_M), "robot");
    belt = sensing == Sensing.NONE ? Optional.empty() : Optional.of(kind.fit(this, sonars));
    belt.ifPresent(sensing::configure);
  }

  @Override
  protected void initBehavior() {
    setTranslationalVelocity(TURN_RATE_RAD_PER_S * Circle.RADIUS_M);
    setRotationalVelocity(TURN_RATE_RAD_PER_S);
  }

  /** Takes a belt on, at half its height. */
  void carry(RangeSensorBelt added) {
    addSensorDevice(added, new Vector3d(0, getHeight() / 2, 0), 0);
  }

  boolean hears() {
    return belt.map(RangeSensorBelt::oneHasHit).orElse(false);
  }
}
