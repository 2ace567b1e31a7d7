package simbad.blindworld.world;

import java.util.ArrayList;
import java.util.List;

/**
 * An obstacle as it really stands: points along its outline, a place, a turn, thresholds, and the
 * time within each run during which it is there.
 *
 * <p>Distances come from points sampled along the outline, at most a millimetre apart on small
 * obstacles, corners among them, and ten times as close round the nearest one.
 */
public final class Body {

  private static final int MOST_SAMPLES = 400;
  private static final double FINEST_STEP_M = 0.001;

  /** Into how many pieces the way to a neighbouring sample is parted where it matters. */
  private static final int FINER = 10;

  private final Point place;
  private final double turnRad;
  private final Shadow shadow;
  private final double fromS;
  private final double untilS;
  private final double[] ownXM;
  private final double[] ownZM;
  private final double[] worldXM;
  private final double[] worldZM;
  private final double radiusM;

  private Body(Body shape, Point place, double turnRad, Shadow shadow, double[] windowS) {
    this(shape.ownXM, shape.ownZM, place, turnRad, shadow, windowS[0], windowS[1]);
  }

  private Body(
      double[] ownXM,
      double[] ownZM,
      Point place,
      double turnRad,
      Shadow shadow,
      double fromS,
      double untilS) {
    this.ownXM = ownXM;
    this.ownZM = ownZM;
    this.place = place;
    this.turnRad = turnRad;
    this.shadow = shadow;
    this.fromS = fromS;
    this.untilS = untilS;
    worldXM = new double[ownXM.length];
    worldZM = new double[ownXM.length];
    double greatest = 0;
    for (int i = 0; i < ownXM.length; i++) {
      double cos = StrictMath.cos(turnRad);
      double sin = StrictMath.sin(turnRad);
      worldXM[i] = place.xM() + ownXM[i] * cos + ownZM[i] * sin;
      worldZM[i] = place.zM() - ownXM[i] * sin + ownZM[i] * cos;
      greatest = Math.max(greatest, StrictMath.hypot(ownXM[i], ownZM[i]));
    }
    radiusM = greatest;
  }

  /** The obstacle as its scene has it, there all the time. */
  public static Body of(Obstacle obstacle) {
    List<Point> samples = samples(obstacle.outline());
    return new Body(
        samples.stream().mapToDouble(Point::xM).toArray(),
        samples.stream().mapToDouble(Point::zM).toArray(),
        obstacle.place(),
        obstacle.turnRad(),
        obstacle.shadow(),
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }

  private static List<Point> samples(List<Point> outline) {
    double perimeter = 0;
    for (int i = 0; i < outline.size(); i++) {
      perimeter += edgeM(outline, i);
    }
    double step = Math.max(FINEST_STEP_M, perimeter / MOST_SAMPLES);
    List<Point> samples = new ArrayList<>();
    for (int i = 0; i < outline.size(); i++) {
      Point from = outline.get(i);
      Point to = outline.get((i + 1) % outline.size());
      int pieces = Math.max(1, (int) Math.ceil(edgeM(outline, i) / step));
      for (int k = 0; k < pieces; k++) {
        double share = (double) k / pieces;
        samples.add(
            new Point(
                from.xM() + share * (to.xM() - from.xM()),
                from.zM() + share * (to.zM() - from.zM())));
      }
    }
    return samples;
  }

  private static double edgeM(List<Point> outline, int i) {
    Point from = outline.get(i);
    Point to = outline.get((i + 1) % outline.size());
    return StrictMath.hypot(to.xM() - from.xM(), to.zM() - from.zM());
  }

  /** The same obstacle moved by so much. */
  public Body moved(double byXM, double byZM) {
    Point other = new Point(place.xM() + byXM, place.zM() + byZM);
    return new Body(this, other, turnRad, shadow, new double[] {fromS, untilS});
  }

  /** The same obstacle turned by so much, counter-clockwise. */
  public Body turned(double byRad) {
    return new Body(this, place, turnRad + byRad, shadow, new double[] {fromS, untilS});
  }

  /** The same obstacle with other thresholds. */
  public Body with(Shadow other) {
    return new Body(this, place, turnRad, other, new double[] {fromS, untilS});
  }

  /** The same obstacle, there only from one time within each run until before another. */
  public Body during(double beginS, double endS) {
    return new Body(this, place, turnRad, shadow, new double[] {beginS, endS});
  }

  /** Its thresholds. */
  public Shadow shadow() {
    return shadow;
  }

  /** Where its origin stands. */
  public Point place() {
    return place;
  }

  /** True when it is there at that time within a run. */
  public boolean isThereAt(double tS) {
    return tS >= fromS && tS < untilS;
  }

  /**
   * How it lies before a transducer at a pose with a beam; {@code index} is its place in the world.
   */
  public Sight seenFrom(Pose pose, Beam beam, int index) {
    double dx = pose.xM() - place.xM();
    double dz = pose.zM() - place.zM();
    double centreM = StrictMath.hypot(dx, dz);
    double bearing = StrictMath.atan2(dx, dz) - turnRad;
    double threshold = shadow.atM(bearing);
    double axis = pose.headingRad() + beam.axisRad();
    int nearest = nearest(pose, axis, beam.halfAngleRad(), centreM);
    if (nearest < 0) {
      return new Sight(index, centreM, bearing, Double.POSITIVE_INFINITY, 0, threshold);
    }
    Point point = refined(nearest, pose, axis, beam.halfAngleRad());
    double offAxis =
        Math.IEEEremainder(StrictMath.atan2(-point.zM(), point.xM()) - axis, 2 * Math.PI);
    double distanceM = StrictMath.hypot(point.xM(), point.zM());
    return new Sight(index, centreM, bearing, distanceM, offAxis, threshold);
  }

  /** The nearest point between a sample and its neighbours, as seen from the pose. */
  private Point refined(int nearest, Pose pose, double axisRad, double halfAngleRad) {
    int n = worldXM.length;
    double forwardX = StrictMath.cos(axisRad);
    double forwardZ = -StrictMath.sin(axisRad);
    double cos = StrictMath.cos(halfAngleRad);
    double x0 = worldXM[nearest] - pose.xM();
    double z0 = worldZM[nearest] - pose.zM();
    Point best = new Point(x0, z0);
    double least = x0 * x0 + z0 * z0;
    for (int neighbour : new int[] {(nearest + 1) % n, (nearest + n - 1) % n}) {
      for (int k = 1; k < FINER; k++) {
        double x = x0 + (worldXM[neighbour] - worldXM[nearest]) * k / FINER;
        double z = z0 + (worldZM[neighbour] - worldZM[nearest]) * k / FINER;
        double square = x * x + z * z;
        double along = x * forwardX + z * forwardZ;
        if (square < least && along > 0 && along * along >= cos * cos * square) {
          least = square;
          best = new Point(x, z);
        }
      }
    }
    return best;
  }

  private int nearest(Pose pose, double axisRad, double halfAngleRad, double centreM) {
    if (centreM > 2 * radiusM && farOff(pose, axisRad, halfAngleRad, centreM)) {
      return -1;
    }
    double forwardX = StrictMath.cos(axisRad);
    double forwardZ = -StrictMath.sin(axisRad);
    double cos = StrictMath.cos(halfAngleRad);
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < worldXM.length; i++) {
      double x = worldXM[i] - pose.xM();
      double z = worldZM[i] - pose.zM();
      double square = x * x + z * z;
      if (square < least) {
        double along = x * forwardX + z * forwardZ;
        if (along > 0 && along * along >= cos * cos * square) {
          least = square;
          best = i;
        }
      }
    }
    return best;
  }

  /** True when even the circle round the obstacle is beside the cone. */
  private boolean farOff(Pose pose, double axisRad, double halfAngleRad, double centreM) {
    double towards = StrictMath.atan2(pose.zM() - place.zM(), place.xM() - pose.xM());
    double beside = Math.abs(Math.IEEEremainder(towards - axisRad, 2 * Math.PI));
    return beside > halfAngleRad + StrictMath.asin(radiusM / centreM) + 1e-9;
  }
}
