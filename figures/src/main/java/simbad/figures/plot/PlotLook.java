package simbad.figures.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;

/**
 * Colour, width and dash of a role, and who is drawn over whom.
 *
 * <p>The colours are those of Okabe and Ito (Color Universal Design, 2008), which stay apart for
 * the common kinds of colour blindness; every two roles also differ in width or dash, for print in
 * grey. The table is thin and lies on top: a trace that follows it shows as a broad fringe.
 *
 * @param depth the least is drawn first
 */
record PlotLook(Color colour, BasicStroke stroke, int depth) {
  private static final Color PALE = new Color(0xD2DCE4);
  private static final Color BLACK = new Color(0x000000);
  private static final Color ORANGE = new Color(0xE69F00);
  private static final Color SKY_BLUE = new Color(0x56B4E9);
  private static final Color BLUISH_GREEN = new Color(0x009E73);
  private static final Color BLUE = new Color(0x0072B2);
  private static final Color VERMILLION = new Color(0xD55E00);
  private static final Color REDDISH_PURPLE = new Color(0xCC79A7);

  /** Tol's muted scheme: the eighth colour of Okabe and Ito, a yellow, is too pale on white. */
  private static final Color WINE = new Color(0x882255);

  /** Short enough that a dash pattern makes it a row of round dots. */
  private static final float DOT = 0.01f;

  private static final float SLIM = 1.6f;

  private static final List<float[]> DASHES =
      List.of(
          new float[0],
          new float[] {7f, 4f},
          new float[] {2f, 4f},
          new float[] {7f, 3.5f, DOT, 3.5f},
          new float[] {DOT, 3.5f},
          new float[] {11f, 3f, 2f, 3f, 2f, 3f});

  private static final float[] WIDTHS = {1.6f, 2.6f, 0.8f};

  /** How many curves of one colour can be told apart. */
  static final int PATTERNS = DASHES.size() * WIDTHS.length;

  static PlotLook of(SeriesRole role) {
    return switch (role) {
      case BAND -> new PlotLook(PALE, PlotInk.round(7f), -1);
      case TABLE -> new PlotLook(BLACK, PlotInk.round(0.9f), 7);
      case ORIGINAL -> new PlotLook(VERMILLION, PlotInk.round(1.5f, 6f, 4f), 2);
      case SHADOW -> new PlotLook(SKY_BLUE, PlotInk.round(3f), 0);
      case OVERLAP -> new PlotLook(BLUISH_GREEN, PlotInk.round(1.6f, 7f, 3f, DOT, 3f), 3);
      case RAY -> new PlotLook(REDDISH_PURPLE, PlotInk.round(1.8f, DOT, 3.4f), 4);
      case NOISY -> new PlotLook(BLUE, PlotInk.round(1.4f, 2.5f, 3f), 5);
      case LEVEL -> new PlotLook(WINE, PlotInk.round(2.2f, 9f, 4f), 6);
      case OTHER -> new PlotLook(ORANGE, PlotInk.round(2f), 1);
    };
  }

  /** The same for graphs, where nothing lies under a thin line and a broad one only blurs. */
  PlotLook slim() {
    float width = Math.min(stroke.getLineWidth(), SLIM);
    float[] dash = stroke.getDashArray();
    return new PlotLook(colour, PlotInk.round(width, dash == null ? new float[0] : dash), depth);
  }

  /** The same colour in another width or dash; pattern 0 is the role's own. */
  PlotLook withPattern(int pattern) {
    if (pattern == 0) {
      return this;
    }
    float width = WIDTHS[(pattern - 1) / DASHES.size()];
    return new PlotLook(
        colour, PlotInk.round(width, DASHES.get((pattern - 1) % DASHES.size())), depth);
  }

  /** The stroke with which the legend stands for a series of this look. */
  BasicStroke legendStroke(SeriesStyle style) {
    return style == SeriesStyle.POINTS ? PlotInk.round(dotSize(), DOT, 7f) : stroke;
  }

  /** The diameter of a dot in points: a cloud's are larger than a thin line's corners. */
  float dotSize() {
    return Math.max(2.1f, 1.6f * stroke.getLineWidth());
  }
}
