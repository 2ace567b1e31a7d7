package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class BigDigitsTest {
  @Test
  void figures_areFiveLinesHigh() {
    assertEquals(
        List.of(
            "  ██    ██████", //
            "████        ██",
            "  ██        ██",
            "  ██        ██",
            "██████      ██"),
        BigDigits.of("17"));
    assertEquals(5, BigDigits.of("12.3").size());
    assertEquals(List.of("", "", "", "", ""), BigDigits.of(" "));
    assertEquals("██      ██████  ██████  ██████", BigDigits.of("LOST").get(0));
    assertEquals("██████  ██████", BigDigits.of("0°").get(0));
  }
}
