package simbad.figures.page;

import java.util.List;
import simbad.figures.markup.Markup;

/**
 * A piece of a page. Where a method takes parts, a {@code Html} is put in as it is and anything
 * else as text, so that names with markup in them stay text.
 */
public final class Html {
  /** A piece with nothing in it. */
  public static final Html NONE = new Html("");

  private final String markup;

  private Html(String markup) {
    this.markup = markup;
  }

  /** Only the kit writes markup; everybody else puts it together. */
  static Html raw(String markup) {
    return new Html(markup);
  }

  /**
   * Returns parts one behind the other.
   *
   * @param parts texts, numbers and pieces
   */
  public static Html of(Object... parts) {
    StringBuilder all = new StringBuilder();
    for (Object part : parts) {
      all.append(part instanceof Html html ? html.markup : text(part.toString()));
    }
    return new Html(all.toString());
  }

  /**
   * Returns pieces one behind the other.
   *
   * @param parts in their order
   */
  public static Html all(List<Html> parts) {
    return of(parts.toArray());
  }

  private static String text(String words) {
    return Markup.escaped(words).replace("\u00a0", "&nbsp;");
  }

  /** Returns parts that matter. */
  public static Html strong(Object... parts) {
    return element("strong", "", parts);
  }

  /** Returns parts that a program reads or writes. */
  public static Html code(Object... parts) {
    return element("code", "", parts);
  }

  /** Returns parts that may be passed over. */
  public static Html soft(Object... parts) {
    return styled("span", "soft", parts);
  }

  /**
   * Returns a square in the colour that stands for something.
   *
   * @param style of the style sheet
   */
  public static Html key(String style) {
    return styled("span", "key " + style);
  }

  /**
   * Returns an element of a class of the style sheet.
   *
   * @param tag its name
   * @param style its class or classes
   * @param parts what it holds
   */
  public static Html styled(String tag, String style, Object... parts) {
    return element(tag, attribute("class", style), parts);
  }

  /**
   * Returns an element with a place or size of its own.
   *
   * @param tag its name
   * @param style its class or classes
   * @param css declarations
   * @param parts what it holds
   */
  public static Html placed(String tag, String style, String css, Object... parts) {
    return element(tag, attribute("class", style) + attribute("style", css), parts);
  }

  /**
   * Returns a link.
   *
   * @param target beside the page
   * @param parts its words
   */
  public static Html link(String target, Object... parts) {
    return element("a", attribute("href", target), parts);
  }

  static Html element(String tag, String attributes, Object... parts) {
    return new Html("<" + tag + attributes + ">" + of(parts).markup + "</" + tag + ">");
  }

  static String attribute(String name, String value) {
    return " " + name + "=\"" + text(value) + "\"";
  }

  /** Returns the same with a line's end behind it. */
  Html line() {
    return new Html(markup + "\n");
  }

  /** Tells whether there is nothing in it. */
  public boolean isEmpty() {
    return markup.isEmpty();
  }

  /** Returns the markup. */
  @Override
  public String toString() {
    return markup;
  }
}
