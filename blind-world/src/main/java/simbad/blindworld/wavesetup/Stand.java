package simbad.blindworld.wavesetup;

import java.util.List;
import simbad.blindworld.wave.Counter;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.Upright;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/** One article by itself on a turntable before the sonar: all that its user sees of the world. */
final class Stand {

  /** A reading so far from where the article is has nothing to do with it. */
  private static final double ELSEWHERE_M = 0.15;

  private final Article article;
  private final WaveWorld world;
  private final Counter counter;
  private final Chance random;

  Stand(WaveWorld.Parts parts, Article article, Upright upright, Chance random) {
    Target alone = new Target(article.outline(), upright, new Point(0, 0), 0);
    this.article = article;
    this.world = new WaveWorld(parts.with(List.of(alone)), List.of());
    this.counter = parts.counter();
    this.random = random;
  }

  Article article() {
    return article;
  }

  /** The sonar so far from the axis at a bearing, looking so much beside it. */
  Place at(double bearingRad, double distanceM, double asideRad) {
    double x = distanceM * StrictMath.sin(bearingRad);
    double z = distanceM * StrictMath.cos(bearingRad);
    Pose pose = new Pose(x, z, StrictMath.atan2(z, -x) + asideRad);
    return new Place(world.standing(pose), surfaceM(x, z));
  }

  /** How far the article's surface is from a point. */
  private double surfaceM(double x, double z) {
    double least = Double.POSITIVE_INFINITY;
    List<Point> corners = article.corners();
    for (int i = 0; i < corners.size(); i++) {
      Point a = corners.get(i);
      Point b = corners.get((i + 1) % corners.size());
      double dx = b.xM() - a.xM();
      double dz = b.zM() - a.zM();
      double along = ((x - a.xM()) * dx + (z - a.zM()) * dz) / (dx * dx + dz * dz);
      double share = Math.max(0, Math.min(1, along));
      least = Math.min(least, StrictMath.hypot(x - a.xM() - share * dx, z - a.zM() - share * dz));
    }
    return least;
  }

  /** A place of the sonar. */
  final class Place {

    private final WaveWorld.Standing standing;
    private final double surfaceM;

    private Place(WaveWorld.Standing standing, double surfaceM) {
      this.standing = standing;
      this.surfaceM = surfaceM;
    }

    /** The distance to the article's surface, by the tape. */
    double surfaceM() {
      return surfaceM;
    }

    /** One reading; infinite for none. */
    double rangeM() {
      double arrival = standing.arrivalS(random);
      return arrival < Double.POSITIVE_INFINITY ? counter.rangeM(arrival) : arrival;
    }

    /** True when a ping reads the article. */
    boolean hears() {
      return Math.abs(rangeM() - surfaceM) < ELSEWHERE_M;
    }

    /** How many of some pings read the article. */
    int heard(int pings) {
      int heard = 0;
      for (int i = 0; i < pings; i++) {
        heard += hears() ? 1 : 0;
      }
      return heard;
    }
  }
}
