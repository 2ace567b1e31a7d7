package simbad.sim;

import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Node;
import javax.media.j3d.Transform3D;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Facets;
import simbad.kernel.geometry.CylinderShape;
import simbad.kernel.geometry.PrismShape;
import simbad.kernel.geometry.Shape;
import simbad.kernel.scene.Ball;
import simbad.kernel.scene.Clearance;

/**
 * Something that moves: it has a start, a position, devices and a share in every step.
 *
 * <p>A step asks every agent to sense, then every agent to act, then moves all of them. The
 * protected methods are the stations of a step; programs may override them.
 */
public class SimpleAgent extends BaseObject {
  private static final int DEFAULT_FRAMES_PER_SECOND = 20;

  /** Room for the rounding of a floating-point height. */
  private static final double ON_GROUND_M = 1e-6;

  private static final int PRISM_SIDES = 15;

  /** The agent's name. */
  protected String name;

  /** Scratch space, as are the transforms that follow. */
  protected Vector3d v1 = new Vector3d();

  protected Transform3D t3d1 = new Transform3D();
  protected Transform3D t3d2 = new Transform3D();
  protected Transform3D t3d3 = new Transform3D();

  /** Metres travelled since the last reset. */
  protected double odometer;

  /** Whether the last step moved the agent. */
  protected boolean positionChanged;

  /** The drawn body, if a window draws one. */
  protected @Nullable Node body;

  /** Height, metres. */
  protected float height = 0.5f;

  /** Radius, metres. */
  protected float radius = 0.3f;

  /** Mass, kilograms. */
  protected float mass = 50;

  /**
   * Friction at rest, for physics; also in motion where {@link #dynamicFrictionCoefficient} is 0.
   */
  protected float staticFrictionCoefficient;

  /** Friction in motion, for physics. */
  protected float dynamicFrictionCoefficient;

  /** Acceleration, metres per second squared, for physics. */
  protected Vector3d linearAcceleration = new Vector3d();

  /** Angular acceleration, radians per second squared, for physics. */
  protected Vector3d angularAcceleration = new Vector3d();

  /** Velocity, metres per second. */
  protected Vector3d linearVelocity = new Vector3d();

  /** Angular velocity, radians per second. */
  protected Vector3d angularVelocity = new Vector3d();

  /** Displacement that this step would bring, metres. */
  protected Vector3d instantTranslation = new Vector3d();

  /** Turn that this step would bring, radians; only y counts. */
  protected Vector3d instantRotation = new Vector3d();

  /** Kept for programs that use it, like the next one. */
  protected double[] collisionDistance = {};

  protected double collisionRadius;

  private final Vector3d startPosition;
  private final DeviceRack devices = new DeviceRack();
  private final Ball next = new Ball();
  private final Clearance clearance = new Clearance();
  private @Nullable Simulator simulator;
  private @Nullable SimpleAgent veryNearAgent;
  private boolean bodyIsDrawn;
  private boolean collided;
  private boolean stoppedByAgent;
  private boolean interacted;
  private double lifeTime;
  private int counter;

  /**
   * Creates an agent.
   *
   * @param pos where its base stands at the start, metres; copied
   * @param name its name
   */
  public SimpleAgent(Vector3d pos, String name) {
    startPosition = new Vector3d(pos);
    this.name = name;
  }

  @Override
  protected List<Shape> bodyShapes() {
    return List.of(
        restores(Compatibility.ROBOTS_ARE_PRISMS)
            ? PrismShape.regular(PRISM_SIDES, radius, height)
            : new CylinderShape(radius, height));
  }

  /**
   * Gives the agent its looks. Programs that override it without calling this method, and add nodes
   * of their own, are drawn as these nodes alone.
   */
  protected void create3D() {
    bodyIsDrawn = true;
  }

  /**
   * Returns the body's shapes, unless {@link #create3D()} was overridden to draw something else.
   */
  @Override
  protected List<Facets> drawing() {
    return bodyIsDrawn || nodes().isEmpty() ? super.drawing() : List.of();
  }

  /** Prepares the agent for its world; called once, by the simulator. */
  protected void create() {
    createLooks(this::create3D);
  }

  /** Returns to the start: position, counters, devices. */
  protected void reset() {
    odometer = 0;
    lifeTime = 0;
    counter = 0;
    interacted = false;
    clearVeryNear();
    resetPosition();
    resetDevices();
  }

  /** Returns to the start position, heading along +x. */
  protected void resetPosition() {
    linearVelocity.set(0, 0, 0);
    angularVelocity.set(0, 0, 0);
    v1.set(startPosition);
    v1.y += height / 2;
    resetPositionAt(v1);
  }

  /** Puts the agent's middle at a point in metres, heading along +x, free of collision. */
  protected void resetPositionAt(Vector3d position) {
    placement().moveTo(position.x, position.y, position.z);
    placement().resetTurn();
    collided = false;
    placementChanged();
  }

  /** Resets every device. */
  protected void resetDevices() {
    devices.reset();
  }

  /** Lets every sensor sense that is due. */
  protected void updateSensors(double elapsedSecond, @Nullable BranchGroup pickableSceneBranch) {
    devices.updateSensors(elapsedSecond, pickableSceneBranch);
  }

  /** Lets every actuator act that is due. */
  protected void updateActuators(double elapsedSecond) {
    devices.updateActuators(elapsedSecond);
  }

  /** Sets the velocities that the motors give; a simple agent has none. */
  protected void setMotorsAcceleration(double elapsedSecond) {
    // No motors.
  }

  /** Adds what the accelerations give in a step to the velocities. */
  protected void integratesVelocities(double elapsedSecond) {
    linearVelocity.scaleAdd(elapsedSecond, linearAcceleration, linearVelocity);
    angularVelocity.scaleAdd(elapsedSecond, angularAcceleration, angularVelocity);
  }

  /**
   * Computes the displacement and turn that the velocities at the end of a step give. The
   * displacement is that of the mean velocity, exact while the acceleration is constant.
   */
  protected void integratesPositionChange(double elapsedSecond) {
    instantTranslation.scale(elapsedSecond, linearVelocity);
    if (linearAcceleration.lengthSquared() > 0 && !meets(Compatibility.GRAVITY_GROWS_WITH_MASS)) {
      instantTranslation.scaleAdd(
          -elapsedSecond * elapsedSecond / 2, linearAcceleration, instantTranslation);
    }
    instantRotation.scale(elapsedSecond, angularVelocity);
  }

  /** Returns how far the base is above the floor, metres. */
  protected double distanceToGround() {
    return placement().yM() - height / 2;
  }

  /** Moves by this step's displacement, unless the agent has collided, and turns. */
  protected void updatePosition() {
    boolean moves = !collided && instantTranslation.lengthSquared() != 0;
    boolean turns =
        instantRotation.y != 0 && !(collided && meets(Compatibility.BLOCKED_ROBOTS_DO_NOT_TURN));
    positionChanged = moves || turns;
    if (moves) {
      placement().moveBy(instantTranslation.x, instantTranslation.y, instantTranslation.z);
      odometer += instantTranslation.length();
    }
    if (turns) {
      placement().turnAboutY(instantRotation.y);
    }
    if (positionChanged) {
      placementChanged();
    }
    if (collided && hasPhysics()) {
      loseVelocity();
    }
  }

  /** What cannot move has no momentum; motors go on turning. */
  private void loseVelocity() {
    double share = hasMotors() ? 1 : 0;
    linearVelocity.set(share * linearVelocity.x, 0, share * linearVelocity.z);
  }

  /**
   * Sets the collision flag: whether the agent's bounding sphere, moved by this step's
   * displacement, touches a static object that cannot be traversed, or another agent stops it.
   *
   * @param pickableSceneBranch the drawn scene, if there is one; not needed
   * @param checkGeometry accepted for old programs
   */
  protected void checkCollision(@Nullable BranchGroup pickableSceneBranch, boolean checkGeometry) {
    collided = !detachedFromSceneGraph && (stoppedByAgent || runsIntoObject());
  }

  /** Returns true if this step would lead into a static object. */
  boolean runsIntoObject() {
    next.set(nextX(), nextY(), nextZ(), radius);
    return world != null && world.getScene().stopsBall(next, clearance);
  }

  /** Returns true if the agent drives, so that it is stopped by walls and does not bounce. */
  boolean hasMotors() {
    return false;
  }

  /** Returns true if there is air under the agent. */
  boolean isAboveGround() {
    return distanceToGround() > ON_GROUND_M;
  }

  /** Returns true if physics governs the agent's height now. */
  boolean isFalling() {
    return hasPhysics() && mass > 0 && isAboveGround();
  }

  private boolean hasPhysics() {
    return simulator != null && simulator.getUsePhysics();
  }

  /** Says whether the agent has pushed something or bounced in this step. */
  void setInteracted(boolean newInteracted) {
    interacted = newInteracted;
  }

  /** Says whether another agent stops this one in this step. */
  void setStoppedByAgent(boolean stopped) {
    stoppedByAgent = stopped;
  }

  /** Returns where the agent's middle is after this step, if nothing stops it: x, then y and z. */
  double nextX() {
    return placement().xM() + instantTranslation.x;
  }

  double nextY() {
    return placement().yM() + instantTranslation.y;
  }

  double nextZ() {
    return placement().zM() + instantTranslation.z;
  }

  /** Returns true if the agent does not move in this step, because something is in its way. */
  boolean isStopped() {
    return collided;
  }

  /** Says that a body is in the agent's way. */
  void setStopped() {
    collided = true;
  }

  /** Counts a step. */
  protected void updateCounters(double elapsedSecond) {
    counter++;
    lifeTime += elapsedSecond;
  }

  /** Called before {@link #initBehavior()}. */
  protected void initPreBehavior() {
    // For subclasses.
  }

  /** Called once when the simulation starts. */
  protected void initBehavior() {
    // For subclasses.
  }

  /** Called in every step before {@link #performBehavior()}. */
  protected void performPreBehavior() {
    // For subclasses.
  }

  /** Called in every step, after all sensors have sensed and before anything moves. */
  protected void performBehavior() {
    // For subclasses.
  }

  /** Returns true if a static object or another agent stopped this one in the last step. */
  public boolean collisionDetected() {
    return collided;
  }

  /** Returns true if in the last step physics let the agent push another one or bounce. */
  public boolean interactionDetected() {
    return interacted;
  }

  /** Goes back to the start position. Counters stay. */
  public void moveToStartPosition() {
    resetPosition();
  }

  /** Puts the agent's middle at a point in metres, heading along +x; velocities stay. */
  public void moveToPosition(Vector3d position) {
    resetPositionAt(position);
  }

  /** Puts the agent's middle above a point of the floor in metres; height and velocities stay. */
  public void moveToPosition(double x, double z) {
    v1.set(x, placement().yM(), z);
    resetPositionAt(v1);
  }

  /** Puts the middle above a point in metres and heads there, radians; height, velocities stay. */
  public void setPose(double x, double z, double headingRad) {
    moveToPosition(x, z);
    rotateY(headingRad);
  }

  /**
   * Adds a sensor.
   *
   * @param position where it sits, metres from the agent's middle
   * @param angle its turn about the vertical axis, radians
   * @return its number, for {@link #getSensorDevice(int)}
   */
  protected int addSensorDevice(SensorDevice sensor, Vector3d position, double angle) {
    addDevice(sensor, position, angle);
    return devices.add(sensor);
  }

  /**
   * Adds an actuator.
   *
   * @param position where it sits, metres from the agent's middle
   * @param angle its turn about the vertical axis, radians
   * @return its number, for {@link #getActuatorDevice(int)}
   */
  protected int addActuatorDevice(ActuatorDevice actuator, Vector3d position, double angle) {
    addDevice(actuator, position, angle);
    return devices.add(actuator);
  }

  private void addDevice(Device device, Vector3d position, double angle) {
    device.setOwner(this);
    device.translateTo(position);
    device.rotateY(angle);
    addChild(device);
    findWorld().ifPresent(device::setWorld);
  }

  /** Frees what the agent holds. */
  protected void dispose() {
    // For subclasses.
  }

  /** Describes the agent's state in several lines: metres, seconds. */
  public synchronized String asString() {
    return AgentText.of(this);
  }

  /** Says which simulator steps the agent. */
  protected void setSimulator(Simulator newSimulator) {
    simulator = newSimulator;
  }

  /** Returns the sensors. */
  @SuppressWarnings("NonApiType") // The type is Simbad's.
  public ArrayList<SensorDevice> getSensorList() {
    return devices.sensors;
  }

  /** Returns the actuators. */
  @SuppressWarnings("NonApiType") // The type is Simbad's.
  public ArrayList<ActuatorDevice> getActuatorList() {
    return devices.actuators;
  }

  /** Returns the simulated seconds since the last reset. */
  public double getLifeTime() {
    return lifeTime;
  }

  /** Returns the steps per simulated second. */
  public int getFramesPerSecond() {
    return simulator == null ? DEFAULT_FRAMES_PER_SECOND : simulator.getFramesPerSecond();
  }

  /** Writes where the agent's middle is, metres, to a point. */
  public void getCoords(Point3d coords) {
    coords.set(placement().xM(), placement().yM(), placement().zM());
  }

  /** Returns the steps since the last reset. */
  public int getCounter() {
    return counter;
  }

  /** Returns the name. */
  public String getName() {
    return name;
  }

  /** Returns the mass in kilograms. */
  public float getMass() {
    return mass;
  }

  /** Returns the radius in metres. */
  public float getRadius() {
    return radius;
  }

  /** Returns the height in metres. */
  public float getHeight() {
    return height;
  }

  /** Returns a sensor by the number that adding it gave. */
  public SensorDevice getSensorDevice(int num) {
    return devices.sensors.get(num);
  }

  /** Returns an actuator by the number that adding it gave. */
  public ActuatorDevice getActuatorDevice(int num) {
    return devices.actuators.get(num);
  }

  /** Forgets that another agent was near. */
  protected void clearVeryNear() {
    veryNearAgent = null;
  }

  /** Notes that another agent's sphere touches this one's; of several, the last counts. */
  protected void veryNear(SimpleAgent other) {
    veryNearAgent = other;
  }

  /** Returns true if another agent touched this one at the end of the last step. */
  public boolean anOtherAgentIsVeryNear() {
    return veryNearAgent != null;
  }

  /** Returns the agent that touches this one, or null if none does. */
  public @Nullable SimpleAgent getVeryNearAgent() {
    return veryNearAgent;
  }
}
