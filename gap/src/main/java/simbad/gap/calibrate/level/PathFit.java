package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
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
  private static final double DEGREES = 4;

  private final Believed target;
  private final double[][] prior;
  private double[] added;
  private double[] deviation;

  /**
   * Creates one that knows no reading.
   *
   * @param target the obstacle
   */
  PathFit(Believed target) {
    this.target = target;
    prior = Prior.smooth(target.symmetry(), target.pathSpreadM());
    added = new double[target.orbits()];
    deviation = new double[added.length];
    Arrays.fill(deviation, target.pathSpreadM());
  }

  /**
   * Takes readings.
   *
   * @param trials echoes that were read, of which those of this obstacle count
   * @param number of this obstacle
   * @param beyondM by how much each was read too far, metres
   * @param variance of each, square metres
   */
  void fit(List<Trials.Trial> trials, int number, double[] beyondM, double[] variance) {
    RealMatrix precision = MatrixUtils.createRealMatrix(prior);
    double[] right = new double[added.length];
    for (int i = 0; i < beyondM.length; i++) {
      if (trials.get(i).target() == number) {
        int[] orbits = orbits(trials.get(i));
        double share = share(trials.get(i));
        double off = beyondM[i] - at(trials.get(i));
        double own = (DEGREES + 1) / (DEGREES + off * off / variance[i]) / variance[i];
        double[] weights = {1 - share, share};
        for (int a = 0; a < 2; a++) {
          right[orbits[a]] += own * weights[a] * beyondM[i];
          for (int b = 0; b < 2; b++) {
            precision.addToEntry(orbits[a], orbits[b], own * weights[a] * weights[b]);
          }
        }
      }
    }
    CholeskyDecomposition decomposition = Matrices.positive(precision);
    added = decomposition.getSolver().solve(new ArrayRealVector(right)).toArray();
    RealMatrix covariance = decomposition.getSolver().getInverse();
    Arrays.setAll(deviation, i -> Math.sqrt(Math.max(0, covariance.getEntry(i, i))));
  }

  /** What is added at the bearing of a trial, metres. */
  double at(Trials.Trial trial) {
    int[] orbits = orbits(trial);
    return added[orbits[0]] + share(trial) * (added[orbits[1]] - added[orbits[0]]);
  }

  /** How far that may be off, metres. */
  double deviationAt(Trials.Trial trial) {
    int[] orbits = orbits(trial);
    double share = share(trial);
    return deviation[orbits[0]] + share * (deviation[orbits[1]] - deviation[orbits[0]]);
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
    for (int i = 0; i < LevelForms.BEARINGS; i++) {
      int orbit = target.symmetry().orbit(i);
      values[i] = added[orbit];
      values[LevelForms.BEARINGS + i] = deviation[orbit];
    }
    return values;
  }
}
