package simbad.figures.plot;

/** How the points of a series are joined. */
public enum SeriesStyle {
  /** Straight edges from point to point. */
  LINE,
  /** Straight edges, and one from the last point back to the first. */
  CLOSED_LINE,
  /** Dots that are not joined. */
  POINTS,
  /** No edges; what lies within them is filled. A way round a hole goes round it the other way. */
  AREA
}
