package simbad.figures.page;

/**
 * A drawing with what is said of it.
 *
 * @param heading above it; may be empty
 * @param drawing what {@link Svg#html} gave
 * @param caption below it
 * @param more what stands under the caption, such as the numbers as a table; may be empty
 */
public record PagePicture(String heading, Html drawing, Html caption, Html more) {
  /** A drawing without anything below its caption. */
  public PagePicture(String heading, Html drawing, String caption) {
    this(heading, drawing, Html.of(caption), Html.NONE);
  }

  /**
   * Returns the same with its numbers below it, folded.
   *
   * @param summary what they are
   * @param table of them
   */
  public PagePicture with(String summary, Table table) {
    return new PagePicture(heading, drawing, caption, Page.folded(summary, table.html()));
  }

  Html html() {
    return Html.element(
            "figure",
            "",
            heading.isEmpty() ? Html.NONE : Html.element("h3", "", heading).line(),
            drawing,
            Html.element("figcaption", "", caption).line(),
            more)
        .line();
  }
}
