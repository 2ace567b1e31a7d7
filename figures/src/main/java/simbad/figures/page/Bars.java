package simbad.figures.page;

import java.util.ArrayList;
import java.util.List;

/** Bars below each other, each with its name before and its value behind it. */
public final class Bars {
  private final List<Html> rows = new ArrayList<>();

  /**
   * Adds a bar.
   *
   * @param name before it
   * @param share of the whole length; beyond 0 and 1 it ends there
   * @param style its colour
   * @param value behind it
   */
  public Bars bar(String name, double share, String style, String value) {
    return bar(name, fill(share, style), value);
  }

  /**
   * Adds a bar with a line on it that says how sure its end is.
   *
   * @param name before it
   * @param bar what {@link #fill} and {@link #whisker} gave
   * @param value behind it
   */
  public Bars bar(String name, Html bar, String value) {
    rows.add(Html.element("span", "", name));
    rows.add(Html.styled("span", "track", bar));
    rows.add(Html.styled("span", "value", value).line());
    return this;
  }

  /** Returns a bar's coloured part. */
  public static Html fill(double share, String style) {
    return Html.placed("span", "fill " + style, "width:" + Numbers.css(clamp(share)));
  }

  /** Returns the line on a bar from one share to another. */
  public static Html whisker(double low, double high) {
    double from = clamp(low);
    return Html.placed(
        "span",
        "whisker",
        "left:" + Numbers.css(from) + ";width:" + Numbers.css(clamp(high) - from));
  }

  private static double clamp(double share) {
    return Math.max(0, Math.min(1, share));
  }

  /** Returns them as a piece of a page. */
  public Html html() {
    return Html.styled("div", "bars", Html.raw("\n"), Html.all(rows)).line();
  }
}
