package simbad.figures.diagnosis;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Collection;
import java.util.List;
import simbad.definition.Effect;

/** Words and numbers for the page. */
final class Html {
  private static final MathContext DIGITS = new MathContext(3);
  private static final int MOST_DECIMALS = 6;

  private Html() {}

  /** A number with three digits, a true minus and no exponent. */
  static String number(double value) {
    if (!Double.isFinite(value)) {
      return Double.isNaN(value) ? "unknown" : "no bound";
    }
    BigDecimal rounded = new BigDecimal(value).round(DIGITS);
    if (rounded.scale() > MOST_DECIMALS) {
      rounded = rounded.setScale(MOST_DECIMALS, java.math.RoundingMode.HALF_EVEN);
    }
    String text = rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    return text.replace('-', '\u2212');
  }

  /** Centimetres with two decimals. */
  static String centimetres(double value) {
    return fixed(value, 2) + "&nbsp;cm";
  }

  static String percent(double share) {
    return fixed(100 * share, 0) + "&nbsp;%";
  }

  /** A probability as one says it: certainty is never said of what is only nearly so. */
  static String probability(double share) {
    if (share > 0.995 && share < 1) {
      return "&gt;&nbsp;99&nbsp;%";
    }
    return share > 0 && share < 0.005 ? "&lt;&nbsp;1&nbsp;%" : percent(share);
  }

  static String fixed(double value, int decimals) {
    if (!Double.isFinite(value)) {
      return number(value);
    }
    BigDecimal rounded = new BigDecimal(value).setScale(decimals, java.math.RoundingMode.HALF_EVEN);
    String text = rounded.signum() == 0 ? rounded.abs().toPlainString() : rounded.toPlainString();
    return text.replace('-', '\u2212');
  }

  /** Names as a list in words: a, b and c. */
  static String list(Collection<Effect> effects) {
    List<String> words = effects.stream().map(Effect::word).toList();
    if (words.size() < 2) {
      return String.join("", words);
    }
    return String.join(", ", words.subList(0, words.size() - 1))
        + " and "
        + words.get(words.size() - 1);
  }
}
