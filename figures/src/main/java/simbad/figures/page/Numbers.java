package simbad.figures.page;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Numbers as a page says them: a true minus, no exponent, no break before the unit. All are plain
 * text.
 */
public final class Numbers {
  private static final int DIGITS = 3;

  /** A diagnosis.json has no more. */
  private static final int MOST_DIGITS = 6;

  private static final int MOST_DECIMALS = 6;
  private static final double NEARLY = 0.005;

  private Numbers() {}

  /** Returns a number with three digits; no bound for infinity. */
  public static String number(double value) {
    return number(value, DIGITS);
  }

  private static String number(double value, int digits) {
    if (!Double.isFinite(value)) {
      return Double.isNaN(value) ? "unknown" : "no bound";
    }
    BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits));
    if (rounded.scale() > MOST_DECIMALS) {
      rounded = rounded.setScale(MOST_DECIMALS, RoundingMode.HALF_EVEN);
    }
    String text = rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    return text.replace('-', '\u2212');
  }

  /**
   * Returns a number with as many digits as its interval tells, three at least.
   *
   * @param value to say: the estimate, or an end of the interval
   * @param low end of the interval; may be infinite
   * @param high end of the interval; may be infinite
   */
  public static String number(double value, double low, double high) {
    double steps = Math.abs(value) / (high - low);
    // The interval is some steps of the last digit wide.
    int digits = steps > 0 && Double.isFinite(steps) ? (int) Math.ceil(Math.log10(steps)) + 1 : 0;
    return number(value, Math.min(MOST_DIGITS, Math.max(DIGITS, digits)));
  }

  /** Returns centimetres with two decimals and their unit. */
  public static String centimetres(double value) {
    return fixed(value, 2) + "\u00a0cm";
  }

  /** Returns a share in whole per cent. */
  public static String percent(double share) {
    return percent(share, 0);
  }

  /**
   * Returns a share in per cent.
   *
   * @param share of 1
   * @param decimals how many
   */
  public static String percent(double share, int decimals) {
    return fixed(100 * share, decimals) + "\u00a0%";
  }

  /** Returns a probability as one says it: what is only nearly certain is not called certain. */
  public static String probability(double share) {
    if (share > 1 - NEARLY && share < 1) {
      return ">\u00a099\u00a0%";
    }
    return share > 0 && share < NEARLY ? "<\u00a01\u00a0%" : percent(share);
  }

  /** Returns a q-value: three decimals, and none that look like nought. */
  public static String qValue(double q) {
    return q < 1e-3 ? "<\u00a00.001" : fixed(q, 3);
  }

  /**
   * Returns a number with a fixed number of decimals.
   *
   * @param value any
   * @param decimals how many
   */
  public static String fixed(double value, int decimals) {
    if (!Double.isFinite(value)) {
      return number(value);
    }
    BigDecimal rounded = new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN);
    String text = rounded.signum() == 0 ? rounded.abs().toPlainString() : rounded.toPlainString();
    return text.replace('-', '\u2212');
  }

  /** Returns a number as a style sheet or a drawing reads it, with at most so many decimals. */
  static String plain(double value, int decimals) {
    BigDecimal rounded = new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  /** Returns a share of 1 as a style sheet reads it. */
  public static String share(double share) {
    return plain(share, 4);
  }

  /** Returns a share in per cent as a style sheet reads it. */
  public static String css(double share) {
    return plain(100 * share, 2) + "%";
  }
}
