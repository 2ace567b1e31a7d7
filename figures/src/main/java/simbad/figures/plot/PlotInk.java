package simbad.figures.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;

/** Fonts, greys and lines of everything that is not data. Sizes are points, 72 to the inch. */
final class PlotInk {
  /** Logical, so that it exists on every machine; only its face differs between them. */
  private static final Font BASE = new Font(Font.SANS_SERIF, Font.PLAIN, 9);

  static final Font TITLE = BASE.deriveFont(Font.BOLD, 12f);
  static final Font PROVENANCE = BASE.deriveFont(9f);
  static final Font AXIS_TITLE = BASE.deriveFont(10f);
  static final Font TICK = BASE.deriveFont(9f);
  static final Font LEGEND = BASE.deriveFont(9.5f);
  static final Font RING = BASE.deriveFont(8f);

  static final Color TEXT = new Color(0x1A1A1A);
  static final Color SOFT_TEXT = new Color(0x555555);
  static final Color FRAME = new Color(0x707070);
  static final Color GRID = new Color(0xD0D0D0);
  static final Color FINE_GRID = new Color(0xEBEBEB);
  static final Color PAPER = Color.WHITE;
  static final Color OBSTACLE = new Color(0x4D4D4D);

  static final BasicStroke HAIRLINE = new BasicStroke(0.6f);
  static final BasicStroke HALO = round(2.4f);

  private PlotInk() {}

  static BasicStroke round(float width, float... dash) {
    float[] pattern = dash.length == 0 ? null : dash;
    return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 4f, pattern, 0f);
  }
}
