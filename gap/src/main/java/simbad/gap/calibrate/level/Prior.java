package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.level.LevelFigures;
import simbad.sonar.scene.SonarSpec;

/**
 * What is held of the parameters before a reference is read: their means and how surely, normal and
 * independent but for neighbouring distances and bearings. Immutable.
 */
final class Prior {
  // What physics leaves open of a ranger before posts: docs/method/level-model.md.
  private static final double SPREADING = 1.65;
  private static final double SPREADING_SPREAD = 0.2;
  private static final double ABSORPTION_SPREAD = 0.4;
  private static final double RECEIVER_SPREAD_DB = 2;
  private static final double RECEIVER_LENGTH = 0.7;
  private static final double LEVEL_SPREAD_DB = 1;
  private static final double APERTURE_SPREAD = 0.25;
  private static final double SQUINT_SPREAD_RAD = Math.toRadians(2);
  private static final double SCATTER_DB = 1;
  private static final double SCATTER_SPREAD = Math.log(1.35);

  /** A scene that states a value knows it so much better. */
  private static final double STATED = 0.25;

  /** Departures between a table's bearings: spread, and how far they reach. */
  private static final double LOBE_SPREAD_DB = 3;

  private static final double LOBE_LENGTH_DEG = 4;
  private static final double JITTER = 1e-5;

  private final double[] mean;
  private final double[][] precision;

  /**
   * Makes the prior of a sensor before obstacles.
   *
   * @param layout of the parameters
   * @param sensor as believed
   * @param targets what is believed of the obstacles
   * @param transducers of several no squint is common
   */
  Prior(Layout layout, SonarSpec sensor, List<Believed> targets, int transducers) {
    mean = new double[layout.size()];
    precision = new double[layout.size()][layout.size()];
    LevelFigures figures = sensor.law().level();
    boolean n = figures.spreadingExponent().isPresent();
    boolean a = figures.absorptionDbPerM().isPresent();
    set(0, n ? figures.spreadingExponent().getAsDouble() : SPREADING, SPREADING_SPREAD, n);
    set(1, sensor.levelLaw().absorptionDbPerM(), ABSORPTION_SPREAD, a);
    receiver(figures.receiverThresholdDb().isPresent());
    set(Layout.LEVEL, 0, LEVEL_SPREAD_DB, false);
    boolean beam = figures.apertureRadiusM().isPresent();
    set(layout.aperture(), Math.log(aperture(sensor)), APERTURE_SPREAD, beam);
    set(layout.squint(), 0, SQUINT_SPREAD_RAD / (transducers > 1 ? 100 : 1), false);
    boolean sd = figures.excessSdDb().isPresent();
    double scatter = sd ? figures.excessSdDb().getAsDouble() : SCATTER_DB;
    set(layout.scatter(), Math.log(Math.max(0.05, scatter)), SCATTER_SPREAD, sd);
    for (int target = 0; target < targets.size(); target++) {
      lobes(layout.lobe(target, 0), targets.get(target));
    }
  }

  private static double aperture(SonarSpec sensor) {
    // A cone says too little of a beam: its angle is that of some target at some distance.
    return sensor.law().level().apertureRadiusM().orElse(LevelForms.APERTURE_M);
  }

  private void set(int index, double value, double spread, boolean stated) {
    double own = stated ? STATED * spread : spread;
    mean[index] = value;
    precision[index][index] = 1 / (own * own);
  }

  private void receiver(boolean stated) {
    List<Double> at = LevelForms.RECEIVER_M;
    double spread = stated ? STATED * RECEIVER_SPREAD_DB : RECEIVER_SPREAD_DB;
    double[][] covariance = new double[at.size()][at.size()];
    for (int i = 0; i < at.size(); i++) {
      for (int j = 0; j < at.size(); j++) {
        double apart = Math.abs(Math.log(at.get(i) / at.get(j))) / RECEIVER_LENGTH;
        covariance[i][j] = spread * spread * matern(apart);
      }
    }
    place(inverse(covariance), Layout.RECEIVER);
  }

  private void lobes(int from, Believed target) {
    double[][] inverse = smooth(target.symmetry(), LOBE_SPREAD_DB);
    for (int i = 0; i < inverse.length; i++) {
      inverse[i][i] += target.precision(i);
    }
    place(inverse, from);
  }

  /** The precision of what varies with the bearing as a target's lobes do, over its orbits. */
  static double[][] smooth(Symmetry symmetry, double spread) {
    double[] byStep = new double[LevelForms.BEARINGS];
    double stepDeg = 360.0 / byStep.length;
    Arrays.setAll(byStep, i -> matern(Math.min(i, byStep.length - i) * stepDeg / LOBE_LENGTH_DEG));
    int size = symmetry.orbits();
    double[][] covariance = new double[size][size];
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        covariance[i][j] = symmetry.sum(i, j, byStep);
      }
    }
    double[] own = new double[size];
    Arrays.setAll(own, i -> Math.sqrt(covariance[i][i]));
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        covariance[i][j] *= spread * spread / (own[i] * own[j]);
      }
    }
    return inverse(covariance);
  }

  /** Matern's correlation of order 3/2 (Rasmussen and Williams 2006, equation 4.17). */
  static double matern(double apart) {
    double x = Math.sqrt(3) * apart;
    return (1 + x) * Math.exp(-x);
  }

  private static double[][] inverse(double[][] covariance) {
    int size = covariance.length;
    RealMatrix matrix = MatrixUtils.createRealMatrix(size, size);
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        matrix.setEntry(i, j, (covariance[i][j] + covariance[j][i]) / 2);
      }
      matrix.addToEntry(i, i, JITTER * covariance[i][i]);
    }
    return Matrices.positive(matrix).getSolver().getInverse().getData();
  }

  private void place(double[][] block, int from) {
    for (int i = 0; i < block.length; i++) {
      System.arraycopy(block[i], 0, precision[from + i], from, block.length);
    }
  }

  /** Returns the most probable values. */
  double[] mean() {
    return mean.clone();
  }

  /** Returns the matrix of the precision; not to be changed. */
  double[][] precision() {
    return precision;
  }

  /** Returns how improbable values are: half the square of their distance, natural. */
  double cost(double[] values) {
    double sum = 0;
    for (int i = 0; i < mean.length; i++) {
      double[] row = precision[i];
      double product = 0;
      for (int j = 0; j < mean.length; j++) {
        product += row[j] * (values[j] - mean[j]);
      }
      sum += product * (values[i] - mean[i]);
    }
    return sum / 2;
  }
}
