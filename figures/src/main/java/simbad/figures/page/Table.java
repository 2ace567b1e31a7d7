package simbad.figures.page;

import java.util.ArrayList;
import java.util.List;

/**
 * A table that is filled row by row. On a narrow screen it is scrolled by itself, with the keyboard
 * as well.
 */
public final class Table {
  private final List<String> columns;
  private final List<Html> rows = new ArrayList<>();
  private String style = "";
  private String caption = "";
  private String id = "";
  private boolean hasRowHeads;

  private Table(List<String> columns) {
    this.columns = columns;
  }

  /**
   * Begins a table.
   *
   * @param columns titles; one that begins with # is of numbers, without the #
   */
  public static Table of(String... columns) {
    return of(List.of(columns));
  }

  /**
   * Begins a table.
   *
   * @param columns titles; one that begins with # is of numbers, without the #
   */
  public static Table of(List<String> columns) {
    return new Table(List.copyOf(columns));
  }

  /** Names what the rows are of, above the table. */
  public Table caption(String words) {
    caption = words;
    return this;
  }

  /** Gives it a class of the style sheet. */
  public Table styled(String newStyle) {
    style = newStyle;
    return this;
  }

  /** Gives it a name in the page, by which a drawing finds its rows. */
  public Table named(String newId) {
    id = newId;
    return this;
  }

  /** Makes the first cell of each row that is added from now on its head. */
  public Table withRowHeads() {
    hasRowHeads = true;
    return this;
  }

  /**
   * Adds a row.
   *
   * @param cells texts and pieces, one a column
   */
  public Table row(Object... cells) {
    if (cells.length != columns.size()) {
      throw new IllegalArgumentException(cells.length + " cells in " + columns);
    }
    List<Html> row = new ArrayList<>();
    for (int i = 0; i < cells.length; i++) {
      row.add(cell(i, cells[i]));
    }
    rows.add(Html.element("tr", "", row.toArray()).line());
    return this;
  }

  private Html cell(int column, Object content) {
    if (column == 0 && hasRowHeads) {
      return Html.element("th", Html.attribute("scope", "row"), content);
    }
    return isNumber(column)
        ? Html.styled("td", content instanceof Shaded cell ? "n s" + cell.shade() : "n", content)
        : Html.element("td", "", content);
  }

  /**
   * What stands in a cell whose colour says how much it is.
   *
   * @param words in it
   * @param shade from 0, none, to 5
   */
  public record Shaded(String words, int shade) {
    @Override
    public String toString() {
      return words;
    }
  }

  private boolean isNumber(int column) {
    return columns.get(column).startsWith("#");
  }

  private Html head(int column) {
    String scope = Html.attribute("scope", "col");
    return isNumber(column)
        ? Html.element(
            "th",
            scope + Html.attribute("class", "n"),
            Html.element("span", "", columns.get(column).substring(1)))
        : Html.element("th", scope, Html.element("span", "", columns.get(column)));
  }

  /** Returns how many rows there are. */
  public int size() {
    return rows.size();
  }

  /** Returns the table as a piece of a page. */
  public Html html() {
    List<Html> heads = new ArrayList<>();
    for (int i = 0; i < columns.size(); i++) {
      heads.add(head(i));
    }
    String attributes =
        (id.isEmpty() ? "" : Html.attribute("id", id))
            + (style.isEmpty() ? "" : Html.attribute("class", style));
    Html table =
        Html.element(
            "table",
            attributes,
            caption.isEmpty() ? Html.NONE : Html.element("caption", "", caption),
            Html.element("thead", "", Html.element("tr", "", heads.toArray())).line(),
            Html.element("tbody", "", Html.raw("\n"), Html.all(rows)));
    return Html.element(
            "div", Html.attribute("class", "scroll") + Html.attribute("tabindex", "0"), table)
        .line();
  }
}
