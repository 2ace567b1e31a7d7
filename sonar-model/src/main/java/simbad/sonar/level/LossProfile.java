package simbad.sonar.level;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Where along the distance the loss passes a level. Between two points of the receiver's curve the
 * loss is a logarithm and a straight line together, so concave: it has one maximum there, and its
 * least value at an end.
 */
final class LossProfile {
  private static final double DB_PER_NEPER = 20 / Math.log(10);

  private final LevelLaw law;

  LossProfile(LevelLaw law) {
    this.law = law;
  }

  /** From the least distance to the limit, with the points of the receiver's curve between. */
  private double[] stations(double limitM) {
    return stations(0, limitM);
  }

  private double[] stations(double fromM, double limitM) {
    Curve receiver = law.receiverThresholdDb();
    double near = Math.max(LevelLaw.LEAST_DISTANCE_M, fromM);
    double far = Math.max(near, limitM);
    double[] between =
        IntStream.range(0, receiver.size())
            .mapToDouble(receiver::x)
            .filter(x -> x > near && x < far)
            .toArray();
    double[] stations = new double[between.length + 2];
    stations[0] = near;
    System.arraycopy(between, 0, stations, 1, between.length);
    stations[stations.length - 1] = far;
    return stations;
  }

  /** The least loss between two distances. */
  double leastDb(double fromM, double toM) {
    return Arrays.stream(stations(fromM, toM)).map(law::lossDb).min().orElseThrow();
  }

  /** Where the loss is greatest between two neighbouring stations. */
  private double summitM(double fromM, double toM) {
    double fall =
        (law.receiverThresholdDb().at(fromM) - law.receiverThresholdDb().at(toM)) / (toM - fromM)
            - 2 * law.absorptionDbPerM();
    // Derivative of the logarithm = fall.
    double summit =
        fall > 0 ? DB_PER_NEPER * law.spreadingExponent() / fall : Double.POSITIVE_INFINITY;
    return Math.max(fromM, Math.min(toM, summit));
  }

  /** The greatest loss up to a distance. */
  double greatestDb(double limitM) {
    double[] stations = stations(limitM);
    double greatest = Arrays.stream(stations).map(law::lossDb).max().orElseThrow();
    for (int i = 1; i < stations.length; i++) {
      if (stations[i - 1] < stations[i]) {
        greatest = Math.max(greatest, law.lossDb(summitM(stations[i - 1], stations[i])));
      }
    }
    return greatest;
  }

  /** The least distance from which on the loss exceeds a level; the limit where it never does. */
  double firstAboveM(double levelDb, double limitM) {
    double[] stations = stations(limitM);
    if (law.lossDb(stations[0]) > levelDb) {
      return 0;
    }
    for (int i = 1; i < stations.length && stations[i - 1] < stations[i]; i++) {
      double summit = summitM(stations[i - 1], stations[i]);
      if (law.lossDb(summit) > levelDb) {
        return passedM(stations[i - 1], summit, levelDb);
      }
    }
    return Math.max(0, limitM);
  }

  /** The greatest distance at which the loss does not exceed a level; 0 where it always does. */
  double lastUpToM(double levelDb, double limitM) {
    double[] stations = stations(limitM);
    for (int i = stations.length - 1; i > 0; i--) {
      if (law.lossDb(stations[i]) <= levelDb) {
        return Math.max(0, stations[i] > limitM ? limitM : stations[i]);
      }
      if (law.lossDb(stations[i - 1]) <= levelDb) {
        return passedM(stations[i - 1], stations[i], levelDb);
      }
    }
    return 0;
  }

  /** Where between two places the loss, not above the level at the first, exceeds it for good. */
  private double passedM(double upToM, double aboveM, double levelDb) {
    double low = upToM;
    double high = aboveM;
    for (int i = 0; i < 100 && Math.nextUp(low) < high; i++) {
      double middle = (low + high) / 2;
      if (law.lossDb(middle) > levelDb) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return low;
  }
}
