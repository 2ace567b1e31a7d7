package simbad.chance;

import java.util.Random;
import javax.vecmath.Vector3d;
import simbad.chance.RandomProgram.Kind;
import simbad.sim.Agent;
import simbad.sim.DifferentialKinematic;
import simbad.sim.LightSensor;
import simbad.sim.LineSensor;
import simbad.sim.Plan;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** Drives by its sensors, by its wheels, by a plan or by chance. */
final class RandomRobot extends Agent {
  private static final int FASTEST_UPDATES_PER_S = 20;

  private final Kind kind;
  private final RangeSensorBelt belt;
  private final RangeSensorBelt bumpers;
  private final LineSensor lines;
  private final LightSensor left;
  private final LightSensor right;
  private final Plan plan = new Plan(this);
  private final double speed;
  private final double turn;

  RandomRobot(Kind kind, Vector3d at, Random random) {
    super(at, "robot");
    this.kind = kind;
    belt =
        random.nextBoolean()
            ? RobotFactory.addSonarBeltSensor(this, 1 + random.nextInt(12))
            : RobotFactory.addSonarBeltSensor(this, 1 + random.nextInt(24), 3 * random.nextFloat());
    bumpers = RobotFactory.addBumperBeltSensor(this, 1 + random.nextInt(8));
    lines = RobotFactory.addLineSensor(this, 1 + random.nextInt(7));
    left = RobotFactory.addLightSensorLeft(this);
    right = RobotFactory.addLightSensorRight(this);
    setRates(random);
    speed = random.nextDouble();
    turn = random.nextDouble() - 0.5;
    if (kind == Kind.WHEELED) {
      RobotFactory.setDifferentialDriveKinematicModel(this);
    }
    for (int i = random.nextInt(4); i >= 0; i--) {
      plan.forward(random.nextDouble(), 0.1 + random.nextDouble());
      plan.turn(random.nextDouble(), 0.1 + random.nextDouble());
    }
    if (random.nextBoolean()) {
      plan.loop();
    }
  }

  private void setRates(Random random) {
    belt.setUpdateOnEachFrame(random.nextBoolean());
    if (random.nextBoolean()) {
      bumpers.setUpdatePerSecond(1 + random.nextInt(FASTEST_UPDATES_PER_S));
    }
    // Pictures take their time; what is asked of most light sensors is lux.
    int pictures = random.nextInt(8) == 0 ? 3 : 0;
    left.setUpdatePerSecond(pictures);
    right.setUpdatePerSecond(pictures);
  }

  /** Returns a number that changes with everything that the robot may know. */
  double known() {
    double sum = left.getLux() + 2 * right.getLux() + left.getAverageLuminance();
    for (int i = 0; i < belt.getNumSensors(); i++) {
      sum += (i + 1) * finite(belt.getMeasurement(i)) + (belt.hasHit(i) ? 1 : 0);
    }
    for (int i = 0; i < bumpers.getNumSensors(); i++) {
      sum += bumpers.hasHit(i) ? i + 1 : 0;
    }
    for (int i = 0; i < lines.getNumSensors(); i++) {
      sum += lines.hasHit(i) ? i + 1 : 0;
    }
    return sum
        + finite(belt.getFrontLeftQuadrantMeasurement())
        + (anOtherAgentIsVeryNear() ? 7 : 0);
  }

  private static double finite(double measurement) {
    return Double.isInfinite(measurement) ? 1e6 : measurement;
  }

  @Override
  protected void initBehavior() {
    plan.reset();
  }

  @Override
  protected void performBehavior() {
    switch (kind) {
      case PLANNER -> plan.doStep();
      case AVOIDER -> avoid();
      case SEEKER -> drive(speed, 20 * (left.getLux() - right.getLux()) + lineToTheLeft());
      case WHEELED -> wheels().setWheelsVelocity(speed, speed + (bumpers.oneHasHit() ? 1 : turn));
      default -> drive(speed, turn);
    }
  }

  private DifferentialKinematic wheels() {
    return (DifferentialKinematic) kinematicModel;
  }

  private double lineToTheLeft() {
    return lines.hasHit(0) ? 0.5 : 0;
  }

  private void avoid() {
    boolean blocked = collisionDetected() || belt.getFrontQuadrantMeasurement() < 0.6;
    drive(blocked ? 0.1 : speed, blocked || anOtherAgentIsVeryNear() ? 1 : turn);
  }

  private void drive(double t, double r) {
    setTranslationalVelocity(t);
    setRotationalVelocity(r);
  }
}
