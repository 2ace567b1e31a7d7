package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Angles;

/**
 * By how much the echoes of one obstacle come from beyond its nearest point, over its orbits of
 * bearings: a Gaussian process (Rasmussen and Williams 2006, chapter 2), with Student's weights for
 * what lies far off.
 */
final class PathFit {
  private final Believed target;
  private final double[][] prior;
  private final List<Trials.Trial> read;

  /** Of the echoes that were read, those of this obstacle. */
  private final int[] own;

  private double[] added;
  private CholeskyDecomposition known;
  private RealMatrix solved;
  private double[] alone;

  /**
   * Creates one that knows no reading.
   *
   * @param target the obstacle
   * @param number of this obstacle
   * @param read echoes that were read, of all obstacles
   */
  PathFit(Believed target, int number, List<Trials.Trial> read) {
    this.target = target;
    this.read = read;
    own = IntStream.range(0, read.size()).filter(i -> read.get(i).target() == number).toArray();
    prior = Prior.smooth(target.symmetry(), target.pathSpreadM());
    added = new double[target.orbits()];
    alone = added;
    known = Matrices.positive(MatrixUtils.createRealMatrix(prior));
    solved = MatrixUtils.createRealMatrix(added.length, 1);
  }

  /**
   * Takes readings, and takes out of the equations of what all obstacles share what its own
   * bearings explain.
   *
   * @param shared the equations
   * @param row of each echo, how much each shared value counts
   * @param weight of each echo, one over square metres
   */
  void leave(Normal shared, double[][] row, double[] weight) {
    if (own.length == 0) {
      return;
    }
    int width = row[own[0]].length;
    RealMatrix precision = MatrixUtils.createRealMatrix(prior);
    RealMatrix coupling = MatrixUtils.createRealMatrix(added.length, width);
    double[] right = new double[added.length];
    for (int i : own) {
      int[] orbits = orbits(read.get(i));
      double share = share(read.get(i));
      double[] weights = {1 - share, share};
      for (int a = 0; a < 2; a++) {
        double here = weight[i] * weights[a];
        right[orbits[a]] += here * read.get(i).beyondM();
        for (int b = 0; b < 2; b++) {
          precision.addToEntry(orbits[a], orbits[b], here * weights[b]);
        }
        for (int k = 0; k < width; k++) {
          coupling.addToEntry(orbits[a], k, here * row[i][k]);
        }
      }
    }
    known = Matrices.positive(precision);
    solved = known.getSolver().solve(coupling);
    alone = known.getSolver().solve(new ArrayRealVector(right)).toArray();
    shared.leave(coupling, solved, alone);
  }

  /** Takes the shared values, given which its own follow. */
  void take(double[] shared) {
    if (own.length > 0) {
      double[] taken = solved.operate(shared);
      added = new double[alone.length];
      Arrays.setAll(added, i -> alone[i] - taken[i]);
    }
  }

  /** What is added at the bearing of a trial, metres. */
  double at(Trials.Trial trial) {
    int[] orbits = orbits(trial);
    return added[orbits[0]] + share(trial) * (added[orbits[1]] - added[orbits[0]]);
  }

  /** How far each may be off where the shared values are known, metres. */
  private double[] deviations() {
    RealMatrix covariance = known.getSolver().getInverse();
    double[] deviations = new double[added.length];
    Arrays.setAll(deviations, i -> Math.sqrt(Math.max(0, covariance.getEntry(i, i))));
    return deviations;
  }

  private int[] orbits(Trials.Trial trial) {
    int cell = Math.min((int) place(trial), LevelForms.BEARINGS - 1);
    return new int[] {
      target.symmetry().orbit(cell), target.symmetry().orbit((cell + 1) % LevelForms.BEARINGS)
    };
  }

  private static double share(Trials.Trial trial) {
    return place(trial) - Math.min((int) place(trial), LevelForms.BEARINGS - 1);
  }

  private static double place(Trials.Trial trial) {
    return trial.bearingRad() / Angles.TURN_RAD * LevelForms.BEARINGS;
  }

  /** The values of {@link LevelForms#path}. */
  double[] values() {
    double[] values = new double[2 * LevelForms.BEARINGS];
    double[] deviation = deviations();
    for (int i = 0; i < LevelForms.BEARINGS; i++) {
      int orbit = target.symmetry().orbit(i);
      values[i] = added[orbit];
      values[LevelForms.BEARINGS + i] = deviation[orbit];
    }
    return values;
  }
}
