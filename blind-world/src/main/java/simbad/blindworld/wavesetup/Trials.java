package simbad.blindworld.wavesetup;

import java.util.ArrayList;
import java.util.List;

/** What is found at a few bearings of the first article by turning, repeating and coming near. */
final class Trials {

  private static final double DEGREE = Math.toRadians(1);
  private static final double WIDEST_DEG = 60;
  private static final double NEAR_M = 0.3;

  private final Stand stand;
  private final List<Double> table;
  private final List<Integer> best;
  private final List<Double> halvesDeg;

  Trials(Stand stand, List<Double> table) {
    this.stand = stand;
    this.table = table;
    this.best = spread(table);
    this.halvesDeg = halves();
  }

  /** Four bearings that are heard far, not all of them of one lobe. */
  private static List<Integer> spread(List<Double> table) {
    List<Integer> furthest = User.furthest(table);
    return List.of(furthest.get(0), furthest.get(3), furthest.get(6), furthest.get(9));
  }

  private double bearing(int which) {
    return 2 * Math.PI * best.get(which) / table.size();
  }

  private double threshold(int which) {
    return table.get(best.get(which));
  }

  List<Double> halvesDeg() {
    return halvesDeg;
  }

  private List<Double> halves() {
    List<Double> halves = new ArrayList<>();
    for (int which = 0; which < 3; which++) {
      for (double share : new double[] {0.5, 0.75}) {
        double r = Math.max(NEAR_M, share * threshold(which));
        halves.add((lostAt(which, r, 1) + lostAt(which, r, -1)) / 2);
      }
    }
    return List.copyOf(halves);
  }

  /** The angle at which fewer than half of the pings are answered twice running. */
  private double lostAt(int which, double distanceM, int side) {
    double lost = 0;
    int silent = 0;
    for (double deg = 0; deg < WIDEST_DEG && silent < 2; deg += 0.5) {
      boolean heard = stand.at(bearing(which), distanceM, side * deg * DEGREE).heard(4) >= 2;
      silent = heard ? 0 : silent + 1;
      lost = heard ? deg + 0.25 : lost;
    }
    return lost;
  }

  /** The median half-angle, to half a degree, at least 5. */
  double halfAngleDeg() {
    List<Double> sorted = halvesDeg.stream().sorted().toList();
    double median = (sorted.get(2) + sorted.get(3)) / 2;
    return Math.max(5, Math.rint(2 * median) / 2);
  }

  /** The standard deviation of readings about what the tape says. */
  double noiseM() {
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (int which = 0; which < best.size(); which++) {
      for (double share : new double[] {0.3, 0.5, 0.7}) {
        Stand.Place place = stand.at(bearing(which), Math.max(NEAR_M, share * threshold(which)), 0);
        for (int ping = 0; ping < 20; ping++) {
          double off = place.rangeM() - place.surfaceM();
          if (Math.abs(off) < 0.1) {
            sum += off;
            squares += off * off;
            count++;
          }
        }
      }
    }
    double mean = count == 0 ? 0 : sum / count;
    return count < 2 ? 0.005 : Math.sqrt(Math.max(0, squares / count - mean * mean));
  }

  /** The share of pings that are missed at two fifths of the furthest threshold. */
  double missRate() {
    int pings = 400;
    Stand.Place place = stand.at(bearing(0), Math.max(NEAR_M, 0.4 * threshold(0)), 0);
    return (double) (pings - place.heard(pings)) / pings;
  }

  /**
   * The nearest distance to the surface that is still read rightly, coming nearer by centimetres.
   */
  double minRangeM() {
    double radius = stand.article().outline().radiusM();
    double least = 0.25;
    for (double gap = 0.25; gap > 0.02; gap -= 0.01) {
      Stand.Place place = stand.at(bearing(0), radius + gap, 0);
      double off = place.rangeM() - place.surfaceM();
      if (!(Math.abs(off) < 0.03)) {
        break;
      }
      least = place.surfaceM();
    }
    return Math.round(100 * least) / 100.0;
  }

  /**
   * The width of the logistic fall of the share of pings that are answered, by most likelihood over
   * a grid, with each bearing's own threshold; the median of four.
   */
  double edgeM() {
    List<Double> widths = new ArrayList<>();
    for (int which = 0; which < best.size(); which++) {
      widths.add(edgeM(which));
    }
    widths.sort(null);
    return Math.round(1e4 * (widths.get(1) + widths.get(2)) / 2) / 1e4;
  }

  private double edgeM(int which) {
    int pings = 12;
    double middle = threshold(which);
    List<double[]> counts = new ArrayList<>();
    for (double r = Math.max(NEAR_M, middle - 0.3); r < middle + 0.3; r += 0.03) {
      counts.add(new double[] {r, stand.at(bearing(which), r, 0).heard(pings)});
    }
    double best = Double.NEGATIVE_INFINITY;
    double width = 0.03;
    for (double w = 0.005; w < 0.2; w *= 1.15) {
      for (double t = middle - 0.25; t < middle + 0.25; t += 0.01) {
        double sum = 0;
        for (double[] count : counts) {
          double p = 0.998 / (1 + StrictMath.exp((count[0] - t) / w)) + 0.001;
          sum += count[1] * StrictMath.log(p) + (pings - count[1]) * StrictMath.log(1 - p);
        }
        width = sum > best ? w : width;
        best = Math.max(best, sum);
      }
    }
    return width;
  }
}
