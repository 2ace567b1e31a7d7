package simbad.figures.plot;

import java.awt.Graphics2D;
import java.util.List;

/** Title and provenance over a chart, in as many lines as they take. */
record PlotHeading(List<String> title, List<String> provenance) {
  private static final int TOP = 12;
  private static final int TITLE_LINE = 16;
  private static final int PROVENANCE_LINE = 13;

  /** What the axis to the left and the margin to the right leave of the width. */
  private static final double TEXT_SHARE = 0.84;

  static PlotHeading of(Caption caption, int width) {
    return new PlotHeading(
        Text.wrap(caption.title(), PlotInk.TITLE, width * TEXT_SHARE),
        Text.wrap(caption.provenance(), PlotInk.PROVENANCE, width * TEXT_SHARE));
  }

  int heightPt() {
    return TOP + title.size() * TITLE_LINE + provenance.size() * PROVENANCE_LINE;
  }

  /** Draws upwards from the origin, flush with the plot's left edge. */
  void paint(Graphics2D g, double left) {
    double y = TOP - heightPt();
    for (String line : title) {
      new Text(line, PlotInk.TITLE, PlotInk.TEXT).draw(g, left, y, 0, 0);
      y += TITLE_LINE;
    }
    for (String line : provenance) {
      new Text(line, PlotInk.PROVENANCE, PlotInk.SOFT_TEXT).draw(g, left, y, 0, 0);
      y += PROVENANCE_LINE;
    }
  }
}
