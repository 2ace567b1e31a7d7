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
