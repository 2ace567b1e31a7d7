package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlotLookTest {
  @ParameterizedTest
  @CsvSource({
    "TABLE, 000000",
    "ORIGINAL, D55E00",
    "SHADOW, 56B4E9",
    "BAND, D2DCE4",
    "OVERLAP, 009E73",
    "RAY, CC79A7",
    "NOISY, 0072B2",
    "LEVEL, 882255",
    "OTHER, E69F00"
  })
  void colours_areFixed(SeriesRole role, String rgb) {
    assertEquals(Integer.parseInt(rgb, 16), PlotLook.of(role).colour().getRGB() & 0xFFFFFF);
  }

  @Test
  void everyTwoRoles_differInGreyToo() {
    for (SeriesRole a : SeriesRole.values()) {
      for (SeriesRole b : SeriesRole.values()) {
        if (a != b) {
          assertNotEquals(PlotLook.of(a).stroke(), PlotLook.of(b).stroke(), a + " " + b);
        }
      }
    }
  }

  @Test
  void depths_areDistinct() {
    long distinct =
        Arrays.stream(SeriesRole.values()).map(r -> PlotLook.of(r).depth()).distinct().count();
    assertEquals(SeriesRole.values().length, distinct);
  }

  @Test
  void table_liesOverEverything() {
    for (SeriesRole role : SeriesRole.values()) {
      assertTrue(PlotLook.of(role).depth() <= PlotLook.of(SeriesRole.TABLE).depth());
    }
  }

  @Test
  void words_areWrappedAtTheWidth() {
    assertEquals(List.of("one"), Text.wrap("one", PlotInk.LEGEND, 100));
    List<String> lines = Text.wrap("one two three four five six", PlotInk.LEGEND, 60);
    assertEquals("one two three four five six", String.join(" ", lines));
    lines.forEach(line -> assertTrue(new Text(line, PlotInk.LEGEND, PlotInk.TEXT).width() <= 60));
  }

  @Test
  void longWord_isCut() {
    List<String> lines = Text.wrap("x".repeat(300), PlotInk.LEGEND, 50);
    assertEquals("x".repeat(300), String.join("", lines));
    assertTrue(lines.size() > 20);
  }

  @Test
  void points_knowBothCoordinates() {
    PolarPoint p = PolarPoint.ofOffset(3, -4);
    assertEquals(5, p.radiusM(), 1e-12);
    assertEquals(3, p.xM(), 1e-12);
    assertEquals(-4, p.zM(), 1e-12);
    assertEquals(90, Math.toDegrees(PolarPoint.ofOffset(1, 0).bearingRad()), 1e-12);
  }

  @Test
  void badPoints_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new PolarPoint(Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new PolarPoint(0, -0.1));
    assertThrows(IllegalArgumentException.class, () -> new PolarPoint(0, Double.NaN));
  }
}
