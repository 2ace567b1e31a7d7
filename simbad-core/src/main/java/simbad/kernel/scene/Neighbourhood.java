package simbad.kernel.scene;

import java.util.Arrays;
import simbad.kernel.geometry.Ray;

/**
 * The few parts of a scene that rays from one place can meet: found once, then asked ray by ray.
 * For a belt of short rays this is several times faster than asking the scene for each ray.
 *
 * <p>Holds what was near when {@link Scene#gather} filled it. A mutable buffer; not safe for use by
 * several threads.
 */
public final class Neighbourhood {
  private final Ray local = new Ray();
  private Part[] parts = new Part[8];
  private int size;

  /** Creates an empty neighbourhood. */
  public Neighbourhood() {}

  void clear() {
    size = 0;
  }

  void add(Part part) {
    if (size == parts.length) {
      parts = Arrays.copyOf(parts, 2 * size);
    }
    parts[size++] = part;
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
      Part part = parts[i];
      struck |= part.cover().isReachedBy(ray) && part.strike(ray, local);
    }
    return struck;
  }
}
