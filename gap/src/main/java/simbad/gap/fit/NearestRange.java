package simbad.gap.fit;

import java.util.stream.IntStream;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SonarSpec;

/** The distance to the nearest obstacle in the cone, heard or not. */
public final class NearestRange {
  /**
   * A range that differs by so many standard deviations of the sensor, or steps, is another one.
   */
  private static final double DEVIATIONS = 2;

  private NearestRange() {}

  /**
   * Tells whether two poses see something else: one of them nothing, or ranges that differ by more
   * than the sensor scatters.
   *
   * @param sensor that looks
   * @param oneM what is nearest from one pose, metres; infinity for nothing
   * @param otherM the same from the other
   */
  public static boolean isAnother(SonarSpec sensor, double oneM, double otherM) {
    double most = DEVIATIONS * Math.max(sensor.rangeNoiseM(), sensor.resolutionM());
    return oneM != otherM && !(Math.abs(oneM - otherM) <= most);
  }

  /** Returns it for a ping of a geometry, metres; infinity where nothing is in the cone. */
  public static double inConeM(Geometry geometry, int ping) {
    int first = ping * geometry.obstacles();
    return IntStream.range(first, first + geometry.obstacles())
        .mapToDouble(geometry::nearestM)
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  /**
   * Returns it for a ping whose sensor is turned, metres; infinity where nothing is in the cone.
   *
   * @param model of the scene
   * @param log of the ping
   * @param ping from 0 on
   * @param turnRad by which the sensor is turned, counter-clockwise
   */
  public static double turnedM(NominalModel model, PingLog log, int ping, double turnRad) {
    TransducerPose from = new TransducerPose();
    from.aim(log.xM(ping), log.zM(ping), log.headingRad(ping) + turnRad);
    return IntStream.range(0, model.size())
        .mapToDouble(target -> model.nearestM(target, from))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }
}
