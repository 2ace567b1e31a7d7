package simbad.scene3d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Color3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simbad.kernel.drawing.Rgb;

class PaletteTest {
  private static final Rgb OWN = new Rgb(0.3f, 0.9f, 0.3f);
  private static final Rgb GREY = new Rgb(0.8f, 0.8f, 0.8f);
  private static final Look DARK = Look.LIGHT.withDark(true);

  /** What WCAG 2.1 AA asks for of what is not text: 3 to 1. */
  @ParameterizedTest
  @EnumSource
  void lines_areSeenOnTheFloor(Palette palette) {
    Rgb floor = palette.floor();
    assertTrue(contrast(palette.edge(), floor) > 3, "edge " + contrast(palette.edge(), floor));
    assertTrue(contrast(palette.trail(), floor) > 3, "trail " + contrast(palette.trail(), floor));
    assertTrue(contrast(palette.grid(), floor) > 3, "grid " + contrast(palette.grid(), floor));
  }

  private static double contrast(Color3f line, Rgb floor) {
    double a = luminance(line.x, line.y, line.z);
    double b = luminance(floor.red(), floor.green(), floor.blue());
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  }

  private static double luminance(float red, float green, float blue) {
    return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
  }

  private static double linear(float share) {
    return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
  }

  @Test
  void darkLook_paintsWhatNobodyHasChosen() {
    Backdrop backdrop = new Backdrop(GREY, false, GREY, false);
    assertEquals(GREY, backdrop.background(Look.LIGHT));
    assertEquals(GREY, backdrop.floor(Look.LIGHT));
    assertEquals(Palette.DARK.background(), backdrop.background(DARK));
    assertEquals(Palette.DARK.floor(), backdrop.floor(DARK));
    assertTrue(backdrop.onFloor(DARK).dark());
    assertFalse(backdrop.onFloor(Look.LIGHT).dark());
  }

  @Test
  void ownColours_stay_andLinesGoByTheFloor() {
    Backdrop backdrop = new Backdrop(OWN, true, OWN, true);
    assertEquals(OWN, backdrop.background(DARK));
    assertEquals(OWN, backdrop.floor(DARK));
    assertFalse(backdrop.onFloor(DARK).dark(), "the floor is light");
    Backdrop black = new Backdrop(GREY, false, new Rgb(0, 0, 0), true);
    assertTrue(black.onFloor(Look.LIGHT).dark(), "the floor is black");
  }

  @Test
  void layers_areLeftOutAndDrawnAgain() {
    Look without = DARK.with(Layer.TRAILS, false);
    assertFalse(without.draws(Layer.TRAILS));
    assertTrue(without.draws(Layer.NAMES));
    assertTrue(without.dark());
    Look none = without.with(Layer.NAMES, false).with(Layer.EDGES, false);
    assertTrue(none.layers().isEmpty());
    assertEquals(
        DARK, none.with(Layer.NAMES, true).with(Layer.EDGES, true).with(Layer.TRAILS, true));
  }
}
