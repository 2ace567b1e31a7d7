package simbad.figures.plot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/** Round numbers for rings and ticks: 1, 2 or 5 times a power of ten. */
final class Steps {
  private static final double[] ROUND = {1, 2, 5, 10};

  /** So that 3.0000000000000004 steps count as 3. */
  private static final double SLACK = 1e-9;

  /** Far more than a label shows, far fewer than a double's noise. */
  private static final MathContext DIGITS = new MathContext(9);

  private Steps() {}

  /** The least round number that is not less than a positive value. */
  static double roundUp(double value) {
    double decade = Math.pow(10, Math.floor(Math.log10(value)));
    for (double digit : ROUND) {
      if (digit * decade >= value * (1 - SLACK)) {
        return clean(digit * decade);
      }
    }
    return clean(10 * decade);
  }

  /** The greatest round number that is not more than a positive value. */
  static double roundDown(double value) {
    double decade = Math.pow(10, Math.floor(Math.log10(value)));
    double best = decade;
    for (double digit : ROUND) {
      best = digit * decade <= value * (1 + SLACK) ? digit * decade : best;
    }
    return clean(best);
  }

  /** The round step that divides a positive length into at most so many parts. */
  static double step(double length, int parts) {
    return roundUp(length / parts);
  }

  /** How many steps it takes to reach a length, at least one. */
  static int count(double length, double step) {
    return Math.max(1, (int) Math.ceil(length / step - SLACK));
  }

  /** The multiples of a step from one bound to another, bounds included. */
  static List<Double> multiples(double from, double to, double step) {
    List<Double> values = new ArrayList<>();
    for (long i = (long) Math.ceil(from / step - SLACK); i * step <= to + SLACK * step; i++) {
      values.add(clean(i * step));
    }
    return values;
  }

  /** A plain decimal number without exponent, trailing zeros or a negative zero. */
  static String label(double value) {
    return decimal(value).toPlainString();
  }

  /** Without the noise in the last digits. */
  static double clean(double value) {
    return decimal(value).doubleValue();
  }

  private static BigDecimal decimal(double value) {
    BigDecimal rounded = new BigDecimal(value).round(DIGITS);
    return rounded.signum() == 0 ? BigDecimal.ZERO : rounded.stripTrailingZeros();
  }
}
