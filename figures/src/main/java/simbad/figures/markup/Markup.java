package simbad.figures.markup;

/** Text in HTML and SVG. */
public final class Markup {
  private Markup() {}

  /** Returns a text as it may stand in an element or between quotes in an attribute. */
  public static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
