package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import simbad.experiments.blindcheck.CheckJson;
import simbad.figures.page.Html;
import simbad.figures.page.Table;

/** Counts of what was said, across, by what was so, down; darker is more of the row. */
final class ConfusionTable {
  private static final int SHADES = 5;

  /** Verdicts come first, in this order; effects follow by name. */
  private static final List<String> FIRST =
      List.of(
          "none",
          "single",
          "pair",
          "outside",
          "withheld",
          "explained, named rightly",
          "explained, named otherwise",
          "unexplained",
          "partly",
          "undecided",
          "right",
          "cautious",
          "wrong");

  private static final String SEVERAL = "several names";

  private static final List<String> LAST = List.of(SEVERAL, "no answer", "(no answer)");

  private ConfusionTable() {}

  /** The counts of single effects only, with all answers that name several in one column. */
  static ObjectNode alone(JsonNode counts) {
    ObjectNode alone = CheckJson.object();
    for (var row : counts.properties()) {
      if (!row.getKey().contains("+")) {
        ObjectNode merged = alone.putObject(row.getKey());
        for (var said : row.getValue().properties()) {
          String name = said.getKey().contains("+") ? SEVERAL : said.getKey();
          merged.put(name, merged.path(name).asInt() + said.getValue().asInt());
        }
      }
    }
    return alone;
  }

  /**
   * The table.
   *
   * @param corner what the rows are
   * @param part of the cases
   * @param counts by row and column
   */
  static Html of(String corner, String part, JsonNode counts) {
    Set<String> said = new TreeSet<>(order());
    List<String> rows = new ArrayList<>();
    for (var row : counts.properties()) {
      rows.add(row.getKey());
      row.getValue().fieldNames().forEachRemaining(said::add);
    }
    rows.sort(order());
    List<String> columns = new ArrayList<>(List.of(corner));
    said.forEach(name -> columns.add("#" + name));
    columns.add("#all");
    Table table = Table.of(columns).caption(part).styled("confusion").withRowHeads();
    rows.forEach(name -> addRow(table, name, counts.path(name), said));
    return table.html();
  }

  private static Comparator<String> order() {
    return Comparator.comparingInt(ConfusionTable::group).thenComparing(Comparator.naturalOrder());
  }

  private static int group(String name) {
    int first = FIRST.indexOf(name);
    int last = LAST.indexOf(name);
    return last >= 0 ? FIRST.size() + 1 + last : first < 0 ? FIRST.size() : first;
  }

  private static void addRow(Table table, String name, JsonNode row, Set<String> said) {
    int all = 0;
    for (JsonNode count : row) {
      all += count.asInt();
    }
    List<Object> cells = new ArrayList<>(List.of(name));
    for (String column : said) {
      int count = row.path(column).asInt();
      int shade = (int) Math.ceil((double) SHADES * count / Math.max(1, all));
      cells.add(new Table.Shaded(count == 0 ? "" : count + "", shade));
    }
    cells.add(Html.soft(all));
    table.row(cells.toArray());
  }
}
