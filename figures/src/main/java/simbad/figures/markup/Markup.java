package simbad.figures.markup;

/** Text in HTML and SVG, and the style of the plots in it. */
public final class Markup {
  /**
   * Style sheet of figures: in the dark a plot's paper turns dark and its ink light; hues are
   * turned back again.
   */
  public static final String PLOT_STYLE =
      """
      figure img { background: #fff; }
      @media (prefers-color-scheme: dark) { figure img { filter: invert(.92) hue-rotate(180deg); } }
      """;

  private Markup() {}

  /** Returns a text as it may stand in an element or between quotes in an attribute. */
  public static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
