package simbad.sim;

import javax.vecmath.Vector3d;

/** Equips agents with the usual devices. */
public class RobotFactory extends Factory {
  private static final int SENSORS = 9;
  private static final float SONAR_RANGE_M = 1.5f;
  private static final float BUMPER_RANGE_M = 0.2f;
  private static final float BUMPER_INSET_M = 0.1f;
  private static final int LINE_RAYS = 5;
  private static final float LINE_RANGE_M = 0.025f;
  private static final float LINE_CLEARANCE_M = 0.001f;
  private static final float LAMP_SIZE_M = 0.15f;
  private static final float CAMERA_RADIUS_M = 0.1f;
  private static final int CAMERA_SIDE_PX = 100;
  private static final double CAMERA_ABOVE_TOP_M = 0.075;
  private static final double LIGHT_CLEARANCE_M = 0.5;
  private static final double NEARER_CLEARANCE_M = 0.3;

  /** Creates a factory; its methods are static. */
  public RobotFactory() {}

  /** Adds 9 sonars round the top of an agent, with a range of 1.5 m, 3 updates per second. */
  public static RangeSensorBelt addSonarBeltSensor(Agent agent) {
    return addSonarBeltSensor(agent, SENSORS);
  }

  /** Adds a number of sonars round the top of an agent; otherwise as with 9. */
  public static RangeSensorBelt addSonarBeltSensor(Agent agent, int nbSonars) {
    return addSonarBeltSensor(agent, nbSonars, SONAR_RANGE_M);
  }

  /** Adds a number of sonars with a range in metres; otherwise as with 9. */
  public static RangeSensorBelt addSonarBeltSensor(Agent agent, int nbSonars, float range) {
    RangeSensorBelt belt =
        new RangeSensorBelt(agent.getRadius(), 0, range, nbSonars, RangeSensorBelt.TYPE_SONAR, 0);
    belt.setUpdatePerSecond(3);
    belt.setName("sonars");
    agent.addSensorDevice(belt, new Vector3d(0, agent.getHeight() / 2, 0), 0);
    return belt;
  }

  /** Adds 9 bumpers that reach 0.1 m beyond an agent's rim, 6 updates per second. */
  public static RangeSensorBelt addBumperBeltSensor(Agent agent) {
    return addBumperBeltSensor(agent, SENSORS);
  }

  /** Adds a number of bumpers; otherwise as with 9. */
  public static RangeSensorBelt addBumperBeltSensor(Agent agent, int nbBumpers) {
    RangeSensorBelt belt =
        new RangeSensorBelt(
            agent.getRadius() - BUMPER_INSET_M,
            0,
            BUMPER_RANGE_M,
            nbBumpers,
            RangeSensorBelt.TYPE_BUMPER,
            0);
    belt.setUpdatePerSecond(6);
    belt.setName("bumpers");
    agent.addSensorDevice(belt, new Vector3d(), 0);
    return belt;
  }

  /** Adds 5 rays that look down just ahead of an agent, 20 updates per second. */
  public static LineSensor addLineSensor(Agent agent) {
    return addLineSensor(agent, LINE_RAYS);
  }

  /** Adds a number of rays that look down just ahead of an agent; otherwise as with 5. */
  public static LineSensor addLineSensor(Agent agent, int nbSensors) {
    LineSensor sensor =
        new LineSensor(agent.getRadius() + LINE_CLEARANCE_M, 0, LINE_RANGE_M, nbSensors, 0);
    sensor.setUpdatePerSecond(20);
    sensor.setName("line sensor");
    agent.addSensorDevice(sensor, new Vector3d(0, LINE_RANGE_M - agent.getHeight() / 2, 0), 0);
    return sensor;
  }

  /** Adds a camera on top of an agent, 100 by 100 pixels, 3 updates per second. */
  public static CameraSensor addCameraSensor(Agent agent) {
    CameraSensor camera = new CameraSensor(CAMERA_RADIUS_M, CAMERA_SIDE_PX, CAMERA_SIDE_PX);
    camera.setUpdatePerSecond(3);
    camera.setName("Camera");
    double y = agent.getHeight() / 2 + CAMERA_ABOVE_TOP_M;
    agent.addSensorDevice(camera, new Vector3d(0, y, 0), 0);
    return camera;
  }

  /** Adds a light sensor at the top of an agent that faces right, 3 updates per second. */
  public static LightSensor addLightSensor(Agent agent) {
    return addLightSensor(
        agent, new Vector3d(0, agent.getHeight() / 2, 0), -Math.PI / 2, "Light Sensor");
  }

  /**
   * Adds a light sensor, 3 updates per second.
   *
   * @param position where it sits, metres from the agent's middle; copied
   * @param angle where it faces, radians; it sees what is behind it
   * @param label the last part of its name
   */
  public static LightSensor addLightSensor(
      Agent agent, Vector3d position, float angle, String label) {
    return addLightSensor(agent, position, (double) angle, "Light Sensor " + label);
  }

  /** Adds a light sensor half a metre off the front left of an agent that sees its body there. */
  public static LightSensor addLightSensorLeft(Agent agent) {
    return addLightSensorAside(agent, Math.PI / 4, "left");
  }

  /** Adds a light sensor half a metre off the front right of an agent that sees its body there. */
  public static LightSensor addLightSensorRight(Agent agent) {
    return addLightSensorAside(agent, -Math.PI / 4, "right");
  }

  private static LightSensor addLightSensorAside(Agent agent, double angle, String label) {
    boolean nearer = Compatibility.fromProperty().contains(Compatibility.LIGHT_SENSORS_SIT_NEARER);
    Vector3d position = aside(agent.getRadius(), angle, nearer);
    LightSensor sensor = addLightSensor(agent, position, angle, "Light Sensor " + label);
    sensor.setAside(angle);
    return sensor;
  }

  /** Returns where a light sensor sits that looks at an agent's side, metres. */
  static Vector3d aside(double radius, double angle, boolean nearer) {
    double away = radius + (nearer ? NEARER_CLEARANCE_M : LIGHT_CLEARANCE_M);
    return new Vector3d(away * Math.cos(angle), 0, -away * Math.sin(angle));
  }

  private static LightSensor addLightSensor(
      Agent agent, Vector3d position, double angle, String name) {
    LightSensor sensor = new LightSensor();
    sensor.setUpdatePerSecond(3);
    sensor.setName(name);
    agent.addSensorDevice(sensor, position, angle);
    return sensor;
  }

  /** Adds a sensor of keys to an agent, 3 updates per second. */
  public static KeyInputSensor addKeyInputSensor(Agent agent) {
    KeyInputSensor sensor = new KeyInputSensor();
    sensor.setUpdatePerSecond(3);
    sensor.setName("key input");
    agent.addSensorDevice(sensor, new Vector3d(), 0);
    return sensor;
  }

  /** Adds a lamp on top of an agent, 5 updates per second. */
  public static LampActuator addLamp(Agent agent) {
    LampActuator lamp = new LampActuator(LAMP_SIZE_M);
    lamp.setUpdatePerSecond(5);
    lamp.setName("lamp");
    agent.addActuatorDevice(lamp, new Vector3d(0, agent.getHeight(), 0), 0);
    return lamp;
  }

  /**
   * Lets an agent move on two wheels. Their distance is the agent's radius, not its width: programs
   * are tuned to it.
   */
  public static DifferentialKinematic setDifferentialDriveKinematicModel(Agent agent) {
    DifferentialKinematic kinematic = new DifferentialKinematic(agent.getRadius());
    agent.setKinematicModel(kinematic);
    return kinematic;
  }
}
