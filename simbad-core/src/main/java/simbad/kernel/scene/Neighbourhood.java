package simbad.kernel.scene;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import simbad.kernel.geometry.Extent;
import simbad.kernel.geometry.Ray;

/**
 * The few parts of a scene that rays from one place can meet: found once, then asked ray by ray.
 * For a belt of short rays this is several times faster than asking the scene for each ray.
 *
 * <p>Holds what was near when {@link BodyScene#gather} filled it. Parts that seldom move are
 * gathered from a little farther around, and kept until the place is too far from there: a belt
 * that moves on asks the scene's tree only now and then. A mutable buffer; not safe for use by
 * several threads.
 */
public final class Neighbourhood {
  /** By how much more than needed the ball around kept parts reaches, as a share of its radius. */
  private static final double SLACK = 0.125;

  private static final int STRIDE = 4;
  private final Ray local = new Ray();
  private BodyPart[] parts = new BodyPart[8];

  /** A ball round each part: centre and radius. It turns most rays away without a division. */
  private double[] balls = new double[STRIDE * parts.length];

  private int size;
  private int kept;
  private @Nullable SolidIndex keptFrom;
  private int keptRevision;
  private final Ball keptBall = new Ball();

  /** Creates an empty neighbourhood. */
  public Neighbourhood() {}

  /** Becomes the parts of an index that a ball may touch, and maybe some a little beyond. */
  void keep(SolidIndex index, Ball ball, Solid except) {
    if (keptFrom != index || keptRevision != index.revision() || !keptBall.holds(ball)) {
      size = 0;
      keptBall.set(ball.xM(), ball.yM(), ball.zM(), ball.radiusM() * (1 + SLACK));
      index.gather(keptBall, except, this);
      keptFrom = index;
      keptRevision = index.revision();
      kept = size;
    }
    size = kept;
  }

  void add(BodyPart part) {
    if (size == parts.length) {
      parts = Arrays.copyOf(parts, 2 * size);
      balls = Arrays.copyOf(balls, 2 * balls.length);
    }
    enclose(part.cover(), STRIDE * size);
    parts[size++] = part;
  }

  private void enclose(Extent box, int at) {
    double x = (box.maxX() - box.minX()) / 2;
    double y = (box.maxY() - box.minY()) / 2;
    double z = (box.maxZ() - box.minZ()) / 2;
    balls[at] = box.minX() + x;
    balls[at + 1] = box.minY() + y;
    balls[at + 2] = box.minZ() + z;
    balls[at + 3] = Math.sqrt(x * x + y * y + z * z);
  }

  /** Returns the number of parts. */
  public int size() {
    return size;
  }

  /**
   * Shortens a ray to the nearest surface within its length.
   *
   * @param ray in the world frame, inside the ball that was gathered
   * @return true if the ray met something
   */
  public boolean strike(Ray ray) {
    boolean struck = false;
    for (int i = 0; i < size; i++) {
      BodyPart part = parts[i];
      struck |=
          mayReach(ray, STRIDE * i) && part.cover().isReachedBy(ray) && part.strike(ray, local);
    }
    return struck;
  }

  private boolean mayReach(Ray ray, int ball) {
    double x = balls[ball] - ray.originX();
    double y = balls[ball + 1] - ray.originY();
    double z = balls[ball + 2] - ray.originZ();
    double radiusM = balls[ball + 3];
    double alongM = x * ray.directionX() + y * ray.directionY() + z * ray.directionZ();
    return alongM >= -radiusM
        && alongM <= ray.lengthM() + radiusM
        && x * x + y * y + z * z - alongM * alongM <= radiusM * radiusM;
  }
}
