package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The same digits as exact arithmetic gives. */
class FixedDecimalsTest {
  private static String exact(double value, int decimals) {
    return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN).toPlainString();
  }

  @ParameterizedTest
  @CsvSource({
    "0.5, 0, 0",
    "1.5, 0, 2",
    "-0.0004, 3, 0.000",
    "2.0005, 3, 2.001",
    "0.125, 2, 0.12",
    "-1.05, 1, -1.1",
    "1e15, 2, 1000000000000000.00",
    "0.007, 9, 0.007000000",
    "-12.3, 4, -12.3000"
  })
  void knownNumbers(double value, int decimals, String text) {
    assertEquals(text, FixedDecimals.of(value, decimals));
  }

  @Test
  void anyNumber_isRoundedAsByExactArithmetic() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 200_000; i++) {
      int decimals = random.nextInt(10);
      double value = random.nextDouble(-1, 1) * Math.pow(10, random.nextInt(-9, 13));
      // Halves of the last decimal, where sums of binary numbers just miss the middle.
      double half = Math.rint(value * 100) / 100 + 0.005;
      assertEquals(exact(value, decimals), FixedDecimals.of(value, decimals), "" + value);
      assertEquals(exact(half, 2), FixedDecimals.of(half, 2), "" + half);
    }
  }
}
