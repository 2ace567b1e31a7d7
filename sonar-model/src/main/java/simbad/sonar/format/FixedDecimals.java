package simbad.sonar.format;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Numbers with a fixed number of decimals, correctly rounded, fast enough for millions of them. */
public final class FixedDecimals {
  private static final long[] POWERS = {
    1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000
  };

  /** Below it a product is off by a ten-thousandth at most. */
  private static final double MOST_SCALED = 1e11;

  /** Nearer to the middle of two numbers the product does not say to which one rounds. */
  private static final double SURE = 0.499;

  private FixedDecimals() {}

  /**
   * Returns a number as text.
   *
   * @param value finite
   * @param decimals in [0, 9]
   */
  public static String of(double value, int decimals) {
    StringBuilder text = new StringBuilder();
    append(text, value, decimals);
    return text.toString();
  }

  /**
   * Appends a number. What rounds to zero has no sign; what lies in the middle of two numbers goes
   * to the even one.
   *
   * @param text that it is appended to
   * @param value finite
   * @param decimals in [0, 9]
   */
  public static void append(StringBuilder text, double value, int decimals) {
    double scaled = value * POWERS[decimals];
    double whole = Math.rint(scaled);
    if (Math.abs(scaled) < MOST_SCALED && Math.abs(scaled - whole) < SURE) {
      append(text, (long) whole, decimals);
    } else {
      BigDecimal exact = new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN);
      text.append(exact.toPlainString());
    }
  }

  private static void append(StringBuilder text, long whole, int decimals) {
    long size = Math.abs(whole);
    text.append(whole < 0 ? "-" : "").append(size / POWERS[decimals]);
    if (decimals > 0) {
      long rest = size % POWERS[decimals];
      text.append('.');
      for (int i = decimals - 1; i > 0 && rest < POWERS[i]; i--) {
        text.append('0');
      }
      text.append(rest);
    }
  }
}
