package simbad.figures.page;

import java.util.ArrayList;
import java.util.List;

/** What the lines and colours of a drawing stand for, in the order in which they are said. */
public final class Keys {
  private final List<Html> items = new ArrayList<>();

  /**
   * Says what a line stands for.
   *
   * @param style its class in the drawing
   * @param words what it is
   */
  public Keys line(String style, String words) {
    return add("<path class=\"" + style + "\" d=\"M1 6H45\"/>", words);
  }

  /**
   * Says what a filled shape stands for.
   *
   * @param style its class in the drawing
   * @param words what it is
   */
  public Keys area(String style, String words) {
    return add("<rect class=\"" + style + "\" x=\"8\" width=\"30\" height=\"12\"/>", words);
  }

  private Keys add(String shape, String words) {
    String sample = "<svg viewBox=\"0 0 46 12\" aria-hidden=\"true\">" + shape + "</svg>";
    items.add(Html.element("li", "", Html.raw(sample), words).line());
    return this;
  }

  /** Returns them as a list. */
  public Html html() {
    return Html.styled("ul", "keys", Html.raw("\n"), Html.all(items)).line();
  }
}
