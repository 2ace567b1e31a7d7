package simbad.sim;

import java.util.Arrays;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;

/** A Khepera: 5.5 cm wide, on two wheels, with eight infrared sensors that reach 5 cm. */
public class KheperaRobot extends Agent {
  private static final float RADIUS_M = 0.0275f;
  private static final float IR_RANGE_M = 0.05f;

  /** Where the sensors sit on the rim, from the left round the front to the right, then behind. */
  private static final double[] IR_POSITIONS_DEG = {
    67.5, 45, 15, -15, -45, -67.5, 180 + 22.5, 180 - 22.5
  };

  private static final double[] IR_DIRECTIONS_DEG = {90, 45, 0, 0, -45, -90, 180, 180};

  private final RangeSensorBelt irSensors;
  private final DifferentialKinematic wheels;

  /**
   * Creates a Khepera.
   *
   * @param pos where its base stands at the start, metres; copied
   * @param name its name
   */
  public KheperaRobot(Vector3d pos, String name) {
    super(pos, name);
    radius = RADIUS_M;
    height = 0.03f;
    mass = 0.07f;
    setColor(new Color3f(0.3f, 0.8f, 0.8f));
    wheels = RobotFactory.setDifferentialDriveKinematicModel(this);
    irSensors = createIrSensors();
    addSensorDevice(irSensors, new Vector3d(), 0);
  }

  private static RangeSensorBelt createIrSensors() {
    RangeSensorBelt belt =
        new RangeSensorBelt(
            onCircle(IR_POSITIONS_DEG, RADIUS_M),
            onCircle(IR_DIRECTIONS_DEG, IR_RANGE_M),
            RangeSensorBelt.TYPE_IR,
            RangeSensorBelt.FLAG_SHOW_FULL_SENSOR_RAY);
    belt.setUpdatePerSecond(3);
    belt.setName("IR");
    return belt;
  }

  private static Vector3d[] onCircle(double[] anglesDeg, double radius) {
    return Arrays.stream(anglesDeg)
        .map(Math::toRadians)
        .mapToObj(a -> new Vector3d(radius * Math.cos(a), 0, -radius * Math.sin(a)))
        .toArray(Vector3d[]::new);
  }

  @Override
  protected void create3D() {
    super.create3D();
  }

  /** Returns the infrared sensors: 0 far left, 5 far right, 6 and 7 behind. */
  public RangeSensorBelt getIRSensors() {
    return irSensors;
  }

  /** Sets the velocities of both wheels over ground, metres per second. */
  public void setWheelsVelocity(double left, double right) {
    wheels.setWheelsVelocity(left, right);
  }
}
