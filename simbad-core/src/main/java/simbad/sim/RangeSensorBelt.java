package simbad.sim;

import java.util.Arrays;
import java.util.OptionalDouble;
import javax.swing.JPanel;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.belt.BeltLayout;
import simbad.kernel.belt.Quadrant;
import simbad.kernel.belt.RaySensor;
import simbad.kernel.belt.Sectors;
import simbad.kernel.geometry.Placement;
import simbad.scene3d.Beams;
import simbad.scene3d.Figure;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A belt of range sensors round an agent. Sensors are numbered counter-clockwise as seen from
 * above, sensor 0 looks ahead.
 *
 * <p>What a sensor reads is decided by a {@link Sensor}: thin rays by default, whatever {@link
 * #createSensor(World)} makes in a subclass. A sensor without an echo measures the maximum range,
 * or positive infinity if {@link #FLAG_RETURN_INFINITY} or {@link
 * Compatibility#NO_ECHO_IS_INFINITE} is set.
 */
public class RangeSensorBelt extends PickSensor {
  /** Sonars. */
  public static final int TYPE_SONAR = 0;

  /** Infrared sensors. */
  public static final int TYPE_IR = 1;

  /** Laser sensors. */
  public static final int TYPE_LASER = 2;

  /** Bumpers. */
  public static final int TYPE_BUMPER = 3;

  /** Draws each ray in full length. */
  public static final int FLAG_SHOW_FULL_SENSOR_RAY = 1;

  /** Measures infinity where there is no echo. */
  public static final int FLAG_RETURN_INFINITY = 2;

  private final BeltLayout layout;
  private final Sectors sectors;
  private final float maxRange;
  private final int type;
  private final int flags;
  private final Readings readings;
  private final TransducerPoses poses;
  private final Placement worldFromBelt = new Placement();
  private @Nullable Sensor sensor;

  /**
   * Creates a ring of sensors.
   *
   * @param radius radius of the circle on which the sensors sit, metres
   * @param minRange accepted for old programs; thin rays have no least range
   * @param maxRange greatest range from the circle, metres
   * @param nbsensors number of sensors
   * @param type what kind they are, which changes only how they look
   * @param flags FLAG constants, or-ed
   */
  public RangeSensorBelt(
      float radius, float minRange, float maxRange, int nbsensors, int type, int flags) {
    this(BeltLayout.ring(radius, maxRange, nbsensors), maxRange, type, flags);
  }

  /**
   * Creates sensors at given points.
   *
   * @param positions where the rays start, metres, in the belt's frame; copied
   * @param directions from each start to the end of the ray, metres; copied
   * @param type what kind they are, which changes only how they look
   * @param flags FLAG constants, or-ed
   */
  public RangeSensorBelt(Vector3d[] positions, Vector3d[] directions, int type, int flags) {
    this(BeltLayout.of(coordinates(positions), coordinates(directions)), type, flags);
  }

  private RangeSensorBelt(BeltLayout layout, int type, int flags) {
    this(layout, (float) layout.longestM(), type, flags);
  }

  private RangeSensorBelt(BeltLayout layout, float maxRange, int type, int flags) {
    this.layout = layout;
    this.maxRange = maxRange;
    this.type = type;
    this.flags = flags;
    sectors = new Sectors(layout);
    readings = new Readings(layout.size());
    poses = new TransducerPoses(layout.size());
  }

  private static double[][] coordinates(Vector3d[] vectors) {
    return Arrays.stream(vectors).map(v -> new double[] {v.x, v.y, v.z}).toArray(double[][]::new);
  }

  /**
   * Makes the sensor that this belt asks. Override it to sense by another model.
   *
   * <p>Called once per world, before the first update in it; the owner is known and the world's
   * static objects are all there. The sensor gets the transducers' poses in the world frame, in the
   * order of this belt, and the simulated time since the last reset.
   *
   * @param world what there is to sense
   */
  protected Sensor createSensor(World world) {
    return new RaySensor(world.getScene(), getOwner().getSolid(), layout);
  }

  @Override
  protected void setWorld(World newWorld) {
    super.setWorld(newWorld);
    sensor = null;
  }

  /** Pings with every sensor once. Outside a world nothing is heard. */
  @Override
  protected void update() {
    if (sensor == null) {
      sensor = findWorld().map(this::createSensor).orElse(null);
    }
    if (sensor != null) {
      placeInWorld(worldFromBelt);
      layout.place(worldFromBelt, poses);
      sensor.ping(poses, getOwner().getLifeTime(), readings);
    }
  }

  @Override
  protected void reset() {
    readings.clear();
    if (sensor != null) {
      sensor.reset();
    }
  }

  /** Returns the latest readings as the sensor gave them; to be read only. */
  public Readings getReadings() {
    return readings;
  }

  /** Returns the range that a sensor measures, metres; see the class about no echo. */
  public double getMeasurement(int sensorIndex) {
    return hasHit(sensorIndex) ? readings.rangeM(sensorIndex) : noEcho();
  }

  private double noEcho() {
    boolean finite = (flags & FLAG_RETURN_INFINITY) == 0;
    return finite && !meets(Compatibility.NO_ECHO_IS_INFINITE)
        ? maxRange
        : Double.POSITIVE_INFINITY;
  }

  /** Returns true if a sensor has an echo. */
  public boolean hasHit(int sensorIndex) {
    return readings.isEcho(sensorIndex);
  }

  /** Returns true if any sensor has an echo. */
  public boolean oneHasHit() {
    for (int i = 0; i < readings.size(); i++) {
      if (readings.isEcho(i)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the mean of what the left and the right half of the front measure. A half without echo
   * counts as no echo, not as absent.
   */
  public double getFrontQuadrantMeasurement() {
    return (measurement(Quadrant.FRONT_LEFT_HALF) + measurement(Quadrant.FRONT_RIGHT_HALF)) / 2;
  }

  /** Returns the mean range over the echoes at angles in [0, pi/2]. */
  public double getFrontLeftQuadrantMeasurement() {
    return measurement(Quadrant.FRONT_LEFT);
  }

  /** Returns the mean range over the echoes at angles in [3pi/2, 2pi]. */
  public double getFrontRightQuadrantMeasurement() {
    return measurement(Quadrant.FRONT_RIGHT);
  }

  /** Returns the mean range over the echoes at angles in [pi/4, 3pi/4]. */
  public double getLeftQuadrantMeasurement() {
    return measurement(Quadrant.LEFT);
  }

  /** Returns the mean range over the echoes at angles in [pi/2, pi]. */
  public double getBackLeftQuadrantMeasurement() {
    return measurement(Quadrant.BACK_LEFT);
  }

  /** Returns the mean range over the echoes at angles in [3pi/4, 5pi/4]. */
  public double getBackQuadrantMeasurement() {
    return measurement(Quadrant.BACK);
  }

  /** Returns the mean range over the echoes at angles in [pi, 3pi/2]. */
  public double getBackRightQuadrantMeasurement() {
    return measurement(Quadrant.BACK_RIGHT);
  }

  /** Returns the mean range over the echoes at angles in [5pi/4, 7pi/4]. */
  public double getRightQuadrantMeasurement() {
    return measurement(Quadrant.RIGHT);
  }

  private double measurement(Quadrant quadrant) {
    return getQuadrantMeasurement(quadrant.fromRad(), quadrant.toRad());
  }

  /** Returns the mean range over the echoes at angles from one to another, both included. */
  public double getQuadrantMeasurement(double minAngle, double maxAngle) {
    boolean heard = sectors.echoes(readings, minAngle, maxAngle) > 0;
    return sectors.meanRangeM(readings, minAngle, maxAngle, heard ? 0 : noEcho());
  }

  /** Returns the number of echoes in both halves of the front. */
  public int getFrontQuadrantHits() {
    return hits(Quadrant.FRONT_LEFT_HALF) + hits(Quadrant.FRONT_RIGHT_HALF);
  }

  /** Returns the number of echoes at angles in [0, pi/2]. */
  public int getFrontLeftQuadrantHits() {
    return hits(Quadrant.FRONT_LEFT);
  }

  /** Returns the number of echoes at angles in [3pi/2, 2pi]. */
  public int getFrontRightQuadrantHits() {
    return hits(Quadrant.FRONT_RIGHT);
  }

  /** Returns the number of echoes at angles in [pi/4, 3pi/4]. */
  public int getLeftQuadrantHits() {
    return hits(Quadrant.LEFT);
  }

  /** Returns the number of echoes at angles in [pi/2, pi]. */
  public int getBackLeftQuadrantHits() {
    return hits(Quadrant.BACK_LEFT);
  }

  /** Returns the number of echoes at angles in [3pi/4, 5pi/4]. */
  public int getBackQuadrantHits() {
    return hits(Quadrant.BACK);
  }

  /** Returns the number of echoes at angles in [pi, 3pi/2]. */
  public int getBackRightQuadrantHits() {
    return hits(Quadrant.BACK_RIGHT);
  }

  /** Returns the number of echoes at angles in [5pi/4, 7pi/4]. */
  public int getRightQuadrantHits() {
    return hits(Quadrant.RIGHT);
  }

  private int hits(Quadrant quadrant) {
    return getQuadrantHits(quadrant.fromRad(), quadrant.toRad());
  }

  /** Returns the number of echoes at angles from one to another, both included. */
  public int getQuadrantHits(double minAngle, double maxAngle) {
    return sectors.echoes(readings, minAngle, maxAngle);
  }

  /** Returns the number of sensors. */
  public int getNumSensors() {
    return layout.size();
  }

  /** Returns the angle at which a sensor counts for the quadrants, radians from straight ahead. */
  public double getSensorAngle(int sensorIndex) {
    return layout.angleRad(sensorIndex);
  }

  /** Returns the greatest range in metres. */
  public float getMaxRange() {
    return maxRange;
  }

  /** Returns the flags given to the constructor. */
  public int getFlags() {
    return flags;
  }

  /** Returns a drawing of the belt from above, with what each sensor measures. */
  @Override
  public JPanel createInspectorPanel() {
    return new BeltPanel(this);
  }

  /** Returns the half angle of the cones that are drawn for the sensors; empty for thin rays. */
  protected OptionalDouble findConeHalfAngleRad() {
    return OptionalDouble.empty();
  }

  @Override
  protected void decorate(Figure figure) {
    boolean full = type == TYPE_BUMPER || (flags & FLAG_SHOW_FULL_SENSOR_RAY) != 0;
    Color3f color = type == TYPE_BUMPER ? new Color3f(1, 0, 0) : new Color3f(1, 0.5f, 0.25f);
    figure.add(
        new Beams(
            new Beams.Style(color, findConeHalfAngleRad()),
            SensorBeams.poses(layout),
            SensorBeams.idleLengthsM(layout, full),
            readings));
  }

  /** Returns where the rays start and point, for the window. */
  BeltLayout layout() {
    return layout;
  }

  /** Returns the type given to the constructor, for the window. */
  int type() {
    return type;
  }
}
