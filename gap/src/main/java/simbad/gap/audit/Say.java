package simbad.gap.audit;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers and counts in sentences and options. */
final class Say {
  private static final MathContext DIGITS = new MathContext(4);
  private static final double LEAST_PLAIN = 1e-6;
  private static final double MOST_PLAIN = 1e12;
  private static final MathContext ALL_DIGITS = new MathContext(12);

  private Say() {}

  /** Four digits, an exponent only where there were many noughts. */
  static String number(double value) {
    return plain(value, DIGITS);
  }

  /** So many digits that it is found again in a file. */
  static String exact(double value) {
    return plain(value, ALL_DIGITS);
  }

  private static String plain(double value, MathContext digits) {
    BigDecimal rounded = new BigDecimal(value).round(digits);
    if (rounded.signum() == 0) {
      return "0";
    }
    double size = Math.abs(value);
    boolean isPlain = size >= LEAST_PLAIN && size < MOST_PLAIN;
    BigDecimal stripped = rounded.stripTrailingZeros();
    return isPlain ? stripped.toPlainString() : stripped.toString();
  }

  static String readings(int count) {
    return count == 1 ? "1 reading" : count + " readings";
  }

  static String rows(int count) {
    return count == 1 ? "1 row" : count + " rows";
  }
}
