package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import simbad.figures.page.ColourSight;

/** What the pictures for print tell apart, they tell apart to the colour-blind too. */
class PlotColoursTest {
  private static final double WIDER = 1.5;

  @Test
  void roles_areToldApart() {
    for (SeriesRole one : SeriesRole.values()) {
      for (SeriesRole other : SeriesRole.values()) {
        if (one.compareTo(other) < 0) {
          assertTrue(differ(PlotLook.of(one), PlotLook.of(other)), one + " and " + other);
        }
      }
    }
  }

  /** A sensor on a robot that moves in its own way is dashed as none is by itself. */
  @Test
  void secondSeriesOfARole_areToldApart() {
    for (SeriesRole role : SeriesRole.values()) {
      PlotLook second = PlotLook.of(role).withPattern(PolarSeries.SECOND);
      float[] dash = second.stroke().getDashArray();
      for (SeriesRole other : SeriesRole.values()) {
        assertFalse(
            Arrays.equals(dash, PlotLook.of(other).stroke().getDashArray()),
            role + " and " + other);
      }
    }
  }

  private static boolean differ(PlotLook one, PlotLook other) {
    float width = one.stroke().getLineWidth();
    float otherWidth = other.stroke().getLineWidth();
    return !Arrays.equals(one.stroke().getDashArray(), other.stroke().getDashArray())
        || Math.max(width, otherWidth) >= WIDER * Math.min(width, otherWidth)
        || ColourSight.difference(one.colour(), other.colour()) >= ColourSight.LEAST;
  }

  /** A share that is a tenth more is darker to all eyes. */
  @Test
  void shares_areInOrder() {
    Color before = Ramp.colour(0);
    for (int tenth = 1; tenth <= 10; tenth++) {
      Color after = Ramp.colour(tenth / 10.0);
      double[] light = ColourSight.lightness(before);
      double[] dark = ColourSight.lightness(after);
      for (int eye = 0; eye < light.length; eye++) {
        assertTrue(light[eye] - dark[eye] > 1, tenth + " tenths, eye " + eye);
      }
      before = after;
    }
  }
}
