package simbad.sonar.effect;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.PingLog;

/**
 * What a log shows that a hypothesis leaves unexplained, for an effect to say where its fit starts.
 */
public interface Clues {
  /** Returns the log. */
  PingLog log();

  /** Returns how many obstacles the scene has. */
  int obstacles();

  /** Returns the pings whose echoes the hypothesis cannot explain. */
  IntStream strangeEchoes();

  /** Returns the pings that have an obstacle in the cone and read an echo. */
  IntStream echoesInCone();

  /** Returns the distance to the nearest obstacle in the cone, metres; infinity for none. */
  double nearestM(int ping);

  /** Returns the distances of obstacles that are near enough to answer, metres. */
  DoubleStream audibleM();

  /** Tells whether a ping has one before it in its sequence that read an echo. */
  boolean hasEchoBefore(int ping);

  /** Returns the ranges of strange echoes, metres. */
  default DoubleStream strangeRangesM() {
    return strangeEchoes().mapToDouble(log()::rangeM);
  }

  /** Returns steps that the readings may be multiples of, best first, metres. */
  List<Double> steps();

  /**
   * A line that some echoes lie on, over the readings before them.
   *
   * @param slope by what the reading before is multiplied
   * @param shiftM what is taken from that, metres
   * @param votes echoes that lie on it
   */
  record Line(double slope, double shiftM, int votes) {
    /** Refuses what is no number. */
    public Line {
      Checks.finite("slope", slope);
      Checks.finite("shiftM", shiftM);
    }
  }

  /** Returns the lines that most of some echoes lie on, best first. */
  List<Line> lines(int... echoes);

  /**
   * Returns posts that strange echoes agree on: x, z, radius, reach, share, square.
   *
   * @param mostReachM how far a post may be heard, metres
   */
  List<double[]> posts(double mostReachM);

  /** Returns values of a flat face that strange echoes agree on, for a form that has one. */
  List<double[]> faces(Form form);

  /** Returns values of ranges that walk from ping to ping, for a form that has them. */
  List<double[]> walks(Form form);

  /** Returns the thresholds by bearing that the log shows, obstacle after obstacle, metres. */
  double[] tables(int... obstacles);

  /** Returns the thresholds by bearing over the believed one, less 1, as a Fourier series. */
  double[] waves(int obstacle);

  /**
   * Over which headings a sensor that stood still heard its one obstacle.
   *
   * @param turnRad from the middle of the headings that were expected to that of those at which it
   *     was heard, counter-clockwise
   * @param widerRad by how much half of the arc is wider than expected
   * @param xM by how much the obstacle would be elsewhere in x, as far away as believed
   * @param zM the same in z
   */
  record HeardArc(double turnRad, double widerRad, double xM, double zM) {
    /** Refuses what is no number. */
    public HeardArc {
      Checks.finite("turnRad", turnRad);
      Checks.finite("widerRad", widerRad);
      Checks.finite("xM", xM);
      Checks.finite("zM", zM);
    }
  }

  /** Returns that arc; empty where the sensor moved, or had several obstacles before it. */
  default Optional<HeardArc> heardArc() {
    return Optional.empty();
  }
}
