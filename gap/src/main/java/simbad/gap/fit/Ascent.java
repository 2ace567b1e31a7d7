package simbad.gap.fit;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.EigenDecompositionSymmetric;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealVector;
import simbad.definition.Parameter;

/**
 * Climbs a smooth log likelihood by Newton's method, with slopes and bends from differences. Where
 * it bends upwards it is climbed as if it bent down as much. Says afterwards whether the likelihood
 * was as smooth as that takes.
 */
final class Ascent {
  private static final int ROUNDS = 8;
  private static final int HALVINGS = 3;

  /** Steps before anything is known of a value: shares of the first step of a search. */
  private static final double FIRST_STEP = 0.5;

  private static final double SHORTEST_STEP = 1e-3;

  /** Later ones, in standard deviations of the value: a difference of some tenths of a nat. */
  private static final double STEP_DEVIATIONS = 0.6;

  /** A parabola is trusted so far, in first steps of a search. */
  private static final double MOST_STEPS = 8;

  /** A direction in which it bends by so little of the greatest bend is as good as straight. */
  private static final double LEAST_BEND = 1e-6;

  /** What a smooth likelihood keeps at least of what its parabola promises. */
  private static final double LEAST_KEPT = 0.2;

  /** A promise of less is not held against it, natural. */
  private static final double PROMISE_NATS = 1;

  private final ToDoubleFunction<Hypothesis> logLikelihood;
  private final List<Parameter> parameters;
  private final int from;
  private final double[] scale;
  private final double[] step;
  private Fit here;
  private Fit highest;
  private boolean smooth = true;

  /**
   * Creates an ascent.
   *
   * @param logLikelihood of a set
   * @param start where it begins
   * @param from index of the first value that is moved
   * @param scale first steps of a search, of all values, positive
   */
  Ascent(ToDoubleFunction<Hypothesis> logLikelihood, Hypothesis start, int from, double[] scale) {
    this.logLikelihood = logLikelihood;
    this.from = from;
    this.scale = scale;
    parameters = start.parameters();
    step = new double[start.size() - from];
    for (int i = 0; i < step.length; i++) {
      step[i] = Math.min(FIRST_STEP * scale[from + i], widest(i));
    }
    here = new Fit(start, logLikelihood.applyAsDouble(start));
    highest = here;
  }

  /** From one end of its interval a value steps to the middle at most. */
  private double widest(int value) {
    Parameter parameter = parameters.get(from + value);
    return (parameter.high() - parameter.low()) / 2;
  }

  /** Returns whether the likelihood followed its parabolas to a top. */
  boolean isSmooth() {
    return smooth;
  }

  /**
   * Climbs.
   *
   * @param enoughNats a round that gains less is the last one
   */
  Fit climb(double enoughNats) {
    double gain = Double.POSITIVE_INFINITY;
    for (int round = 0; round < ROUNDS && smooth && gain >= enoughNats; round++) {
      double before = here.logLikelihood();
      Parabola parabola = parabola();
      go(parabola, enoughNats);
      if (highest.logLikelihood() > here.logLikelihood()) {
        smooth &= round == 0 || highest.logLikelihood() - here.logLikelihood() < PROMISE_NATS;
        here = highest;
      }
      gain = here.logLikelihood() - before;
      shorten(parabola);
    }
    // What has not arrived by now never does.
    smooth &= gain < enoughNats;
    return here;
  }

  /** Goes where the parabola has its top, or less far where that is no gain. */
  private void go(Parabola parabola, double enoughNats) {
    double[] move = parabola.move();
    double promised = parabola.promisedNats(move);
    if (promised < enoughNats) {
      return;
    }
    double share = 1;
    for (int halving = 0; halving <= HALVINGS; halving++) {
      Fit there = at(moved(move, share));
      double gain = there.logLikelihood() - here.logLikelihood();
      if (gain > 0) {
        double expected = promised * share * (2 - share);
        smooth = promised < PROMISE_NATS || halving < 2 || gain > LEAST_KEPT * expected;
        here = there;
        return;
      }
      share /= 2;
    }
    smooth = promised < PROMISE_NATS;
  }

  private double[] moved(double[] move, double share) {
    double[] values = here.hypothesis().values();
    for (int i = 0; i < move.length; i++) {
      double most = MOST_STEPS * scale[from + i];
      double own = Math.max(-most, Math.min(most, share * move[i]));
      values[from + i] = parameters.get(from + i).clamp(values[from + i] + own);
    }
    return values;
  }

  /** Steps that fit how surely the values are known. */
  private void shorten(Parabola parabola) {
    for (int i = 0; i < step.length; i++) {
      double bend = Math.abs(parabola.bend[i][i]);
      if (bend > 0) {
        double most = Math.min(scale[from + i], widest(i));
        step[i] = Math.max(SHORTEST_STEP * most, Math.min(most, STEP_DEVIATIONS / Math.sqrt(bend)));
      }
    }
  }

  private Fit at(double... values) {
    Hypothesis set = here.hypothesis().with(values);
    Fit there = new Fit(set, logLikelihood.applyAsDouble(set));
    highest = there.logLikelihood() > highest.logLikelihood() ? there : highest;
    return there;
  }

  /** By how much it is likelier where some values are other than here, natural. */
  private double rise(int one, double by, int other, double otherBy) {
    double[] values = here.hypothesis().values();
    values[from + one] += by;
    values[from + other] += otherBy;
    return by == 0 && otherBy == 0 ? 0 : at(values).logLikelihood() - here.logLikelihood();
  }

  private Parabola parabola() {
    int size = step.length;
    Parabola parabola = new Parabola(step.clone());
    double[] side = new double[size];
    double[] rise = new double[size];
    for (int i = 0; i < size; i++) {
      Parameter parameter = parameters.get(from + i);
      double own = here.hypothesis().values()[from + i];
      double up = Math.min(parameter.high(), own + step[i]) - own;
      double down = Math.max(parameter.low(), own - step[i]) - own;
      // Beside an end of the interval both steps lead away from it, by one and by a half.
      up = up > step[i] / 4 ? up : down / 2;
      down = down < -step[i] / 4 ? down : up / 2;
      double above = rise(i, up, i, 0);
      double below = rise(i, down, i, 0);
      parabola.slope[i] = (above * down / up - below * up / down) / (down - up);
      parabola.bend[i][i] = 2 * (below / down - above / up) / (up - down);
      side[i] = up;
      rise[i] = above;
    }
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < i; j++) {
        double both = rise(i, side[i], j, side[j]) - rise[i] - rise[j];
        parabola.bend[i][j] = -both / (side[i] * side[j]);
        parabola.bend[j][i] = parabola.bend[i][j];
      }
    }
    return parabola;
  }

  /** Slopes and downward bends at a place. */
  private static final class Parabola {
    private final double[] step;
    private final double[] slope;
    private final double[][] bend;

    Parabola(double[] step) {
      this.step = step;
      slope = new double[step.length];
      bend = new double[step.length][step.length];
    }

    /**
     * A value in units of which no bend is over 1: by its own or, where it says little alone but
     * much beside another, by what they bend together over a step of each.
     */
    private double unit(int value) {
      double most = 0;
      for (int i = 0; i < step.length; i++) {
        most = Math.max(most, Math.abs(bend[value][i]) * step[i] * step[value]);
      }
      return most > 0 ? step[value] / Math.sqrt(most) : 0;
    }

    /** The way to its top. */
    double[] move() {
      int size = slope.length;
      double[] unit = new double[size];
      Arrays.setAll(unit, this::unit);
      double[][] scaled = new double[size][size];
      RealVector right = new ArrayRealVector(size);
      for (int i = 0; i < size; i++) {
        right.setEntry(i, slope[i] * unit[i]);
        for (int j = 0; j <= i; j++) {
          scaled[i][j] = bend[i][j] * unit[i] * unit[j];
          scaled[j][i] = scaled[i][j];
        }
      }
      EigenDecompositionSymmetric axes =
          new EigenDecompositionSymmetric(MatrixUtils.createRealMatrix(scaled));
      double greatest = Math.max(1e-300, axes.getD().getNorm1());
      RealVector move = new ArrayRealVector(size);
      for (int k = 0; k < size; k++) {
        RealVector axis = axes.getEigenvector(k);
        double down = Math.max(LEAST_BEND * greatest, Math.abs(axes.getEigenvalue(k)));
        move = move.add(axis.mapMultiply(axis.dotProduct(right) / down));
      }
      for (int i = 0; i < size; i++) {
        move.setEntry(i, move.getEntry(i) * unit[i]);
      }
      return move.toArray();
    }

    /** What it gains by a way to its top, natural. */
    double promisedNats(double[] move) {
      double promised = 0;
      for (int i = 0; i < move.length; i++) {
        promised += slope[i] * move[i] / 2;
      }
      return promised;
    }
  }
}
