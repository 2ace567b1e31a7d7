package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumbersTest {
  @ParameterizedTest
  @CsvSource({
    "0.123456, 0.123",
    "1234567, 1230000",
    "-0.5, \u22120.5",
    "0, 0",
    "1e-9, 0",
    "NaN, unknown",
    "Infinity, no bound",
    "-Infinity, no bound",
    "343.139, 343"
  })
  void numbers_haveThreeDigits(double value, String text) {
    assertEquals(text, Numbers.number(value));
  }

  /** An interval is some steps of the last digit wide; a diagnosis has no more than six digits. */
  @ParameterizedTest
  @CsvSource({
    "1.0501, 1.04989, 1.05032, 1.0501",
    "1.04989, 1.04989, 1.05032, 1.0499",
    "0.95, 0.94, 0.96, 0.95",
    "343.139, 300, 400, 343",
    "1.23456789, 1.23456788, 1.2345679, 1.23457",
    "-2.34567, -2.35, -2.34, \u22122.346",
    "2.34567, -Infinity, Infinity, 2.35",
    "2.34567, 2, Infinity, 2.35",
    "0, 0, 0.1, 0",
    "2.34567, 2.34567, 2.34567, 2.35"
  })
  void estimates_haveTheDigitsOfTheirInterval(double value, double low, double high, String text) {
    assertEquals(text, Numbers.number(value, low, high));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 100\u00a0%",
    "0.999, >\u00a099\u00a0%",
    "0.991, 99\u00a0%",
    "0.004, <\u00a01\u00a0%",
    "0, 0\u00a0%",
    "0.5, 50\u00a0%"
  })
  void probabilities_areNotRoundedToCertainty(double share, String text) {
    assertEquals(text, Numbers.probability(share));
  }

  @Test
  void fixed_hasNoMinusBeforeNothing() {
    assertEquals("0.00", Numbers.fixed(-0.001, 2));
    assertEquals("\u22121.50", Numbers.fixed(-1.5, 2));
  }

  @Test
  void plain_isWhatADrawingReads() {
    assertEquals("0", Numbers.plain(-0.04, 1));
    assertEquals("-1.5", Numbers.plain(-1.5, 2));
    assertEquals("66.3%", Numbers.css(0.663));
  }
}
