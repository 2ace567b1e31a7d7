package simbad.demo;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sim.BallAgent;
import simbad.sim.LampActuator;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/** Physics: two robots push balls about, which roll, slow down, and bounce off walls. */
public class PushBallsDemo extends Demo {
  final List<Robot> robots = new ArrayList<>();
  final List<BallAgent> balls = new ArrayList<>();

  /** Creates the environment. */
  public PushBallsDemo() {
    setUsePhysics(true);
    addSquareOfWalls(9);
    for (int i = 0; i < 16; i++) {
      Vector3d place = new Vector3d(1.3 * (i % 4) - 1.95, 0, 1.3 * Math.floorDiv(i, 4) - 1.95);
      BallAgent ball = new BallAgent(place, "ball " + (i + 1), 0.2f);
      balls.add(ball);
      add(ball);
    }
    for (int side = -1; side <= 1; side += 2) {
      Robot robot =
          new Robot(new Vector3d(side * 3.5, 0, 0.2 + 0.4 * side), "pusher " + (side + 3) / 2);
      robots.add(robot);
      add(robot);
    }
  }

  /** Its sonars look over the balls, so that it turns away from walls and pushes the rest. */
  @SuppressWarnings("ClassCanBeStatic") // Simbad's is an inner class, too.
  public class Robot extends Agent {
    private static final double SPEED_M_PER_S = 0.8;
    private static final double TURN_RAD_PER_S = 1.5;
    private static final double WALL_M = 0.5;

    /** 137 degrees: the golden angle, which leads into every corner in the end. */
    private static final int TURN_STEPS = 32;

    int contacts;
    private final LampActuator lamp;
    private final RangeSensorBelt sonars;
    private final double startHeadingRad;
    private int turning;

    /** Creates a robot where its base shall stand; it starts towards the middle. */
    public Robot(Vector3d position, String name) {
      super(position, name);
      lamp = RobotFactory.addLamp(this);
      sonars = RobotFactory.addSonarBeltSensor(this, 16);
      sonars.setUpdateOnEachFrame(true);
      startHeadingRad = position.x > 0 ? Math.PI : 0;
    }

    /** Has touched nothing yet. */
    @Override
    public void initBehavior() {
      contacts = 0;
      turning = 0;
      rotateY(startHeadingRad);
    }

    /** Counts its impacts on balls. */
    public void contactWith(SimpleAgent other) {
      contacts += other instanceof BallAgent ? 1 : 0;
    }

    /** Drives on or turns; its lamp shines while it touches something. */
    @Override
    public void performBehavior() {
      SimpleAgent near = getVeryNearAgent();
      lamp.setOn(near != null);
      if (near != null) {
        contactWith(near);
      }
      if (turning == 0 && isWallAhead()) {
        turning = TURN_STEPS;
      }
      setTranslationalVelocity(turning > 0 ? 0 : SPEED_M_PER_S);
      setRotationalVelocity(turning > 0 ? TURN_RAD_PER_S : 0);
      turning = Math.max(0, turning - 1);
    }

    private boolean isWallAhead() {
      int last = sonars.getNumSensors() - 1;
      return isNear(0) || isNear(1) || isNear(last);
    }

    private boolean isNear(int sonar) {
      return sonars.hasHit(sonar) && sonars.getMeasurement(sonar) < WALL_M;
    }
  }
}
