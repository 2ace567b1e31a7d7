package simbad.sim;

import java.util.Arrays;
import java.util.OptionalDouble;
import javax.swing.JPanel;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.belt.BeltLayout;
import simbad.kernel.belt.RaySensor;
import simbad.kernel.geometry.Placement;
import simbad.scene3d.Beams;
import simbad.scene3d.Figure;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A row of short rays that look down at the floor and hit the lines there. Ray 0 is the leftmost.
 *
 * <p>A ray without a hit measures the maximum range, or positive infinity if {@link
 * #FLAG_RETURN_INFINITY} is set.
 */
public class LineSensor extends PickSensor {
  /** Draws each ray in full length. */
  public static final int FLAG_SHOW_FULL_SENSOR_RAY = 1;

  /** Measures infinity where there is no hit. */
  public static final int FLAG_RETURN_INFINITY = 2;

  private static final double SPACING_M = 0.03;

  private final BeltLayout layout;
  private final float maxRange;
  private final int flags;
  private final Readings readings;
  private final TransducerPoses poses;
  private final Placement worldFromSensor = new Placement();
  private @Nullable RaySensor rays;

  /**
   * Creates a row across the front, 3 cm from ray to ray.
   *
   * @param radius how far the row is ahead of the sensor's middle, metres
   * @param minRange accepted for old programs; thin rays have no least range
   * @param maxRange greatest range downwards, metres
   * @param nbsensors number of rays
   * @param flags FLAG constants, or-ed
   */
  public LineSensor(float radius, float minRange, float maxRange, int nbsensors, int flags) {
    this(row(radius, nbsensors), down(maxRange, nbsensors), flags);
  }

  /**
   * Creates rays at given points.
   *
   * @param positions where the rays start, metres, in the sensor's frame; copied
   * @param directions from each start to the end of the ray, metres; copied
   * @param flags FLAG constants, or-ed
   */
  public LineSensor(Vector3d[] positions, Vector3d[] directions, int flags) {
    layout = BeltLayout.of(coordinates(positions), coordinates(directions));
    maxRange = (float) layout.longestM();
    this.flags = flags;
    readings = new Readings(layout.size());
    poses = new TransducerPoses(layout.size());
  }

  private static Vector3d[] row(float radius, int size) {
    Vector3d[] row = new Vector3d[size];
    Arrays.setAll(row, i -> new Vector3d(radius, 0, (i - (size - 1) / 2.0) * SPACING_M));
    return row;
  }

  private static Vector3d[] down(float range, int size) {
    Vector3d[] down = new Vector3d[size];
    Arrays.setAll(down, i -> new Vector3d(0, -range, 0));
    return down;
  }

  private static double[][] coordinates(Vector3d[] vectors) {
    return Arrays.stream(vectors).map(v -> new double[] {v.x, v.y, v.z}).toArray(double[][]::new);
  }

  @Override
  protected void setWorld(World newWorld) {
    super.setWorld(newWorld);
    rays = new RaySensor(newWorld.getScene(), getOwner().getSolid(), layout);
  }

  /** Looks along every ray once. Outside a world nothing is hit. */
  @Override
  protected void update() {
    if (rays != null) {
      placeInWorld(worldFromSensor);
      layout.place(worldFromSensor, poses);
      rays.ping(poses, getOwner().getLifeTime(), readings);
    }
  }

  @Override
  protected void reset() {
    readings.clear();
  }

  /** Returns the distance to what a ray hits, metres; see the class about no hit. */
  public double getMeasurement(int sensorIndex) {
    if (hasHit(sensorIndex)) {
      return readings.rangeM(sensorIndex);
    }
    return (flags & FLAG_RETURN_INFINITY) == 0 ? maxRange : Double.POSITIVE_INFINITY;
  }

  /** Returns true if a ray hits something: a line, as a rule. */
  public boolean hasHit(int sensorIndex) {
    return readings.isEcho(sensorIndex);
  }

  /** Returns the number of rays. */
  public int getNumSensors() {
    return layout.size();
  }

  /** Returns the greatest range in metres. */
  public float getMaxRange() {
    return maxRange;
  }

  /** Returns the flags given to the constructor. */
  public int getFlags() {
    return flags;
  }

  /** The rays are too short to be shortened, whatever the flags say. */
  @Override
  protected void decorate(Figure figure) {
    figure.add(
        new Beams(
            new Beams.Style(new Color3f(1, 0.5f, 0.25f), OptionalDouble.empty()),
            SensorBeams.poses(layout),
            SensorBeams.idleLengthsM(layout, true),
            readings));
  }

  /** Returns a row of lamps, one for each ray, lit where there is a hit. */
  @Override
  public JPanel createInspectorPanel() {
    return new HitRowPanel(getNumSensors(), this::hasHit);
  }
}
