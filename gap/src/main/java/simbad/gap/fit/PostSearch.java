package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.hipparchus.exception.MathIllegalStateException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealVector;
import org.hipparchus.optim.nonlinear.vector.leastsquares.LeastSquaresBuilder;
import org.hipparchus.optim.nonlinear.vector.leastsquares.LeastSquaresProblem;
import org.hipparchus.optim.nonlinear.vector.leastsquares.LevenbergMarquardtOptimizer;
import org.hipparchus.optim.nonlinear.vector.leastsquares.MultivariateJacobianFunction;
import org.hipparchus.util.Pair;
import simbad.sonar.effect.Modes;

/**
 * Looks for a post that strange echoes agree on: each votes for all places that its sensor may have
 * heard it from (Hough 1962).
 */
final class PostSearch {
  private static final double CELL_M = 0.06;
  private static final int BEST = 3;
  private static final double[] SQUARE_DEG = {12, 20, 90};
  private static final double[] RADII_M = {0.02, 0.08};

  /** Echoes that agree on a post, first about, then well. */
  private static final double[] WITHIN_M = {0.08, 0.04, 0.03};

  private static final int FEWEST = 6;
  private static final double THIN = 0.1;
  private static final double SAME_M = 0.01;
  private static final double LEAST_M = 1e-6;
  private static final int EVALUATIONS = 100;

  private final LogClues clues;
  private final int[] strange;
  private final double greatestReachM;

  PostSearch(LogClues clues, double greatestReachM) {
    this.clues = clues;
    strange = clues.strangeEchoes().toArray();
    this.greatestReachM = greatestReachM;
  }

  /** A square of the plane. */
  record Cell(long x, long z) implements Comparable<Cell> {
    @Override
    public int compareTo(Cell other) {
      int byX = Long.compare(x, other.x);
      return byX != 0 ? byX : Long.compare(z, other.z);
    }
  }

  /** A post's axis and radius, metres. */
  private record Post(double xM, double zM, double radiusM) {
    boolean isNear(Post other) {
      return Math.hypot(xM - other.xM, zM - other.zM) < SAME_M;
    }
  }

  /** Values of a post to start from: x, z, radius, reach, share, square. */
  List<double[]> starts() {
    List<double[]> starts = new ArrayList<>();
    for (Post post : posts()) {
      for (double square : SQUARE_DEG) {
        starts.add(start(post, greatestReachM, square));
        starts.add(start(post, reachM(post), square));
      }
    }
    return starts.isEmpty() ? List.of(start(new Post(0, 0, 0), greatestReachM, 90)) : starts;
  }

  private static double[] start(Post post, double reach, double square) {
    return new double[] {post.xM, post.zM, post.radiusM, reach, 0.95, square};
  }

  private List<Post> posts() {
    List<Post> posts = new ArrayList<>();
    for (double radius : RADII_M) {
      Map<Cell, Integer> votes = new TreeMap<>();
      for (int ping : strange) {
        vote(ping, radius, votes);
      }
      for (Cell cell : fullest(votes)) {
        Post post = settled(new Post(cell.x * CELL_M, cell.z * CELL_M, radius));
        if (posts.stream().noneMatch(post::isNear)) {
          posts.add(post);
        }
      }
    }
    return posts;
  }

  /**
   * Moves a post to where the echoes agree on it best: the likelihood is so narrow there that a
   * search in steps of its own would stop beside it.
   */
  private Post settled(Post begun) {
    Post post = begun;
    for (double within : WITHIN_M) {
      Post about = post;
      int[] near = IntStream.of(strange).filter(i -> Math.abs(off(i, about)) < within).toArray();
      if (near.length < FEWEST) {
        return post;
      }
      post = agreed(about, near).orElse(about);
    }
    return post;
  }

  /** How much farther an echo came than a post stands, metres. */
  private double off(int ping, Post post) {
    double away = Math.hypot(post.xM - clues.geometry.xM(ping), post.zM - clues.geometry.zM(ping));
    return clues.log.rangeM(ping) + post.radiusM - away;
  }

  /** Least squares; seen from one side only, any radius would do, and a thin post is taken. */
  private Optional<Post> agreed(Post begun, int... near) {
    MultivariateJacobianFunction offs =
        values -> {
          Post post = new Post(values.getEntry(0), values.getEntry(1), values.getEntry(2));
          double[] value = new double[near.length + 1];
          double[][] slope = new double[near.length + 1][];
          for (int i = 0; i < near.length; i++) {
            double x = post.xM - clues.geometry.xM(near[i]);
            double z = post.zM - clues.geometry.zM(near[i]);
            double away = Math.max(LEAST_M, Math.hypot(x, z));
            value[i] = off(near[i], post);
            slope[i] = new double[] {-x / away, -z / away, 1};
          }
          value[near.length] = THIN * post.radiusM;
          slope[near.length] = new double[] {0, 0, THIN};
          return new Pair<>(
              new ArrayRealVector(value, false), new Array2DRowRealMatrix(slope, false));
        };
    LeastSquaresProblem problem =
        new LeastSquaresBuilder()
            .start(new double[] {begun.xM, begun.zM, begun.radiusM})
            .model(offs)
            .target(new double[near.length + 1])
            .maxEvaluations(EVALUATIONS)
            .maxIterations(EVALUATIONS)
            .build();
    try {
      RealVector found = new LevenbergMarquardtOptimizer().optimize(problem).getPoint();
      double radius = Math.max(0, found.getEntry(2));
      return Optional.of(new Post(found.getEntry(0), found.getEntry(1), radius));
    } catch (MathIllegalStateException undecided) {
      // They agree on no one place: on a line of sight all are as good.
      return Optional.empty();
    }
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

  /** From how far the echoes come that agree on a post. */
  private double reachM(Post post) {
    double[] ranges =
        IntStream.of(strange)
            .filter(ping -> Math.abs(off(ping, post)) < CELL_M)
            .mapToDouble(clues.log::rangeM)
            .sorted()
            .toArray();
    return ranges.length == 0
        ? greatestReachM
        : Math.min(greatestReachM, Modes.quantile(ranges, 0.98) + CELL_M / 2);
  }
}
