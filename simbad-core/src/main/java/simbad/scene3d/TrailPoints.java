package simbad.scene3d;

/**
 * The places where something has been, thinned: a place counts when it is far enough from the last
 * one that counted. When there is no more room every second one is left out, and when they are as
 * far apart as they may be, the older half is forgotten. The last point is where it is now.
 */
final class TrailPoints {
  /** How many times the least distance may double. */
  private static final int MOST_DOUBLINGS = 2;

  private final double firstSpacingM;
  private final double[] coordinates;
  private double spacingM;
  private int size;

  /**
   * Creates an empty trail.
   *
   * @param capacity most points, at least 4
   * @param spacingM least distance of points that are kept, at first
   */
  TrailPoints(int capacity, double spacingM) {
    coordinates = new double[3 * capacity];
    firstSpacingM = spacingM;
    this.spacingM = spacingM;
  }

  int size() {
    return size;
  }

  double spacingM() {
    return spacingM;
  }

  /** Returns coordinate 0, 1 or 2 of a point. */
  double get(int point, int axis) {
    return coordinates[3 * point + axis];
  }

  /** Returns the room in which the coordinates are, x, y, z of one point after another. */
  double[] coordinates() {
    return coordinates;
  }

  void clear() {
    size = 0;
    spacingM = firstSpacingM;
  }

  /**
   * Notes where it is now.
   *
   * @return true if other points than the last one are not what they were
   */
  boolean visit(double xM, double yM, double zM) {
    if (size == 0) {
      add(xM, yM, zM);
      add(xM, yM, zM);
      return true;
    }
    set(size - 1, xM, yM, zM);
    if (distanceM(size - 2, xM, yM, zM) < spacingM) {
      return false;
    }
    if (3 * size == coordinates.length) {
      makeRoom();
    }
    add(xM, yM, zM);
    return true;
  }

  /** Returns how far a place is from where it was at last, metres; 0 if it was nowhere. */
  double jumpM(double xM, double yM, double zM) {
    return size == 0 ? 0 : distanceM(size - 1, xM, yM, zM);
  }

  private double distanceM(int point, double xM, double yM, double zM) {
    double x = get(point, 0) - xM;
    double y = get(point, 1) - yM;
    double z = get(point, 2) - zM;
    return Math.sqrt(x * x + y * y + z * z);
  }

  private void makeRoom() {
    if (spacingM < firstSpacingM * (1 << MOST_DOUBLINGS)) {
      spacingM *= 2;
      thin();
    } else {
      int kept = size / 2;
      System.arraycopy(coordinates, 3 * (size - kept), coordinates, 0, 3 * kept);
      size = kept;
    }
  }

  /** Keeps every second point, the first one and the last among them. */
  private void thin() {
    int kept = 0;
    for (int i = 0; i < size; i += i == size - 2 ? 1 : 2) {
      System.arraycopy(coordinates, 3 * i, coordinates, 3 * kept, 3);
      kept++;
    }
    size = kept;
  }

  private void add(double xM, double yM, double zM) {
    size++;
    set(size - 1, xM, yM, zM);
  }

  private void set(int point, double xM, double yM, double zM) {
    coordinates[3 * point] = xM;
    coordinates[3 * point + 1] = yM;
    coordinates[3 * point + 2] = zM;
  }
}
