package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Looks for a post that strange echoes agree on: each votes for all places that its sensor may have
 * heard it from (Hough 1962).
 */
final class PostSearch {
  private static final double CELL_M = 0.06;
  private static final int BEST = 3;
  private static final double[] SQUARE_DEG = {12, 20, 90};
  private static final double[] RADII_M = {0.02, 0.08};

  private final Clues clues;
  private final double greatestReachM;

  PostSearch(Clues clues, double greatestReachM) {
    this.clues = clues;
    this.greatestReachM = greatestReachM;
  }

  /** A square of the plane. */
  record Cell(long x, long z) implements Comparable<Cell> {
    @Override
    public int compareTo(Cell other) {
      int byX = Long.compare(x, other.x);
      return byX != 0 ? byX : Long.compare(z, other.z);
    }

    double distanceM(double xM, double zM) {
      return Math.hypot(x * CELL_M - xM, z * CELL_M - zM);
    }
  }

  /** Values of a post to start from: x, z, radius, reach, share, square. */
  List<double[]> starts() {
    int[] strange = clues.strangeEchoes().toArray();
    List<double[]> starts = new ArrayList<>();
    for (double radius : RADII_M) {
      Map<Cell, Integer> votes = new TreeMap<>();
      for (int ping : strange) {
        vote(ping, radius, votes);
      }
      for (Cell cell : fullest(votes)) {
        for (double square : SQUARE_DEG) {
          starts.add(start(cell, radius, greatestReachM, square));
          starts.add(start(cell, radius, reachM(cell, radius, strange), square));
        }
      }
    }
    return starts.isEmpty() ? List.of(start(new Cell(0, 0), 0, greatestReachM, 90)) : starts;
  }

  private static double[] start(Cell cell, double radius, double reach, double square) {
    return new double[] {cell.x * CELL_M, cell.z * CELL_M, radius, reach, 0.95, square};
  }

  private void vote(int ping, double radiusM, Map<Cell, Integer> votes) {
    double distance = clues.log.rangeM(ping) + radiusM;
    double half = clues.geometry.coneHalfAngleRad();
    int steps = (int) Math.ceil(2 * half * distance / (CELL_M / 2)) + 1;
    Set<Cell> cells = new HashSet<>();
    for (int i = 0; i <= steps; i++) {
      double direction = clues.geometry.headingRad(ping) + half * (2.0 * i / steps - 1);
      cells.add(
          new Cell(
              Math.round((clues.geometry.xM(ping) + distance * Math.cos(direction)) / CELL_M),
              Math.round((clues.geometry.zM(ping) - distance * Math.sin(direction)) / CELL_M)));
    }
    cells.forEach(cell -> votes.merge(cell, 1, Integer::sum));
  }

  /** The cells with most votes, none next to another. */
  private static List<Cell> fullest(Map<Cell, Integer> votes) {
    List<Cell> best = new ArrayList<>();
    votes.entrySet().stream()
        .sorted(Map.Entry.<Cell, Integer>comparingByValue(Comparator.reverseOrder()))
        .map(Map.Entry::getKey)
        .limit(50)
        .forEach(
            cell -> {
              boolean apart =
                  best.stream()
                      .allMatch(
                          other ->
                              Math.max(Math.abs(cell.x - other.x), Math.abs(cell.z - other.z)) > 2);
              if (apart && best.size() < BEST) {
                best.add(cell);
              }
            });
    return best;
  }

  /** From how far the echoes come that agree on a post there. */
  private double reachM(Cell cell, double radiusM, int[] strange) {
    double[] ranges =
        Arrays.stream(strange)
            .filter(
                ping -> {
                  double off =
                      cell.distanceM(clues.geometry.xM(ping), clues.geometry.zM(ping))
                          - radiusM
                          - clues.log.rangeM(ping);
                  return Math.abs(off) < CELL_M;
                })
            .mapToDouble(clues.log::rangeM)
            .sorted()
            .toArray();
    return ranges.length == 0
        ? greatestReachM
        : Math.min(greatestReachM, Modes.quantile(ranges, 0.98) + CELL_M / 2);
  }
}
