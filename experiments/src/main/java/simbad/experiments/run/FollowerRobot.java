package simbad.experiments.run;

import javax.vecmath.Vector3d;
import simbad.experiments.control.Command;
import simbad.experiments.control.Controller;
import simbad.sim.Agent;
import simbad.sim.KinematicModel;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Pose;

/**
 * A robot of 2 cm radius with a belt at its centre; the controller sees the belt and nothing else.
 */
public final class FollowerRobot extends Agent {
  /** Small enough to go where the tables go, metres. */
  public static final float RADIUS_M = 0.02f;

  /** How high it is, metres. */
  public static final float HEIGHT_M = 0.3f;

  private final RangeSensorBelt belt;
  private final Controller controller;
  private final double startHeadingRad;
  private final Command command = new Command();

  /**
   * Creates a robot.
   *
   * @param start where it sets off, its heading taken up when the behaviour starts
   * @param belt its sonars, read in every step
   * @param mountHeightM of the belt above the floor
   * @param controller drives it
   */
  public FollowerRobot(
      Pose start, RangeSensorBelt belt, double mountHeightM, Controller controller) {
    this("robot", start, belt, mountHeightM, controller);
  }

  /**
   * Creates the same with a name of its own.
   *
   * @param name among others
   * @param start where it sets off, its heading taken up when the behaviour starts
   * @param belt its sonars, read in every step
   * @param mountHeightM of the belt above the floor
   * @param controller drives it
   */
  public FollowerRobot(
      String name, Pose start, RangeSensorBelt belt, double mountHeightM, Controller controller) {
    super(new Vector3d(start.position().xM(), 0, start.position().zM()), name);
    Checks.finite("mountHeightM", mountHeightM);
    radius = RADIUS_M;
    height = HEIGHT_M;
    this.belt = belt;
    this.controller = controller;
    startHeadingRad = start.heading().radians();
    belt.setUpdateOnEachFrame(true);
    addSensorDevice(belt, new Vector3d(0, mountHeightM - HEIGHT_M / 2.0, 0), 0);
  }

  /** Lets it move otherwise than it is told. */
  public void movesBy(KinematicModel model) {
    setKinematicModel(model);
  }

  @Override
  protected void initBehavior() {
    rotateY(startHeadingRad);
  }

  @Override
  protected void performBehavior() {
    controller.decide(belt.getReadings(), command);
    setTranslationalVelocity(command.speedMPerS());
    setRotationalVelocity(command.turnRateRadPerS());
  }

  RangeSensorBelt belt() {
    return belt;
  }

  boolean hears() {
    return belt.oneHasHit();
  }
}
