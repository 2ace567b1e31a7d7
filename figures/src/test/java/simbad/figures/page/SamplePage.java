package simbad.figures.page;

import java.util.List;
import simbad.figures.page.Svg.Spot;

/** A page with one picture of each kind that is read in its own way. */
final class SamplePage {
  static final String NAME = "</script><b>a & \"b\"</b>";

  private SamplePage() {}

  static String html() {
    Page page = new Page(NAME, NAME).verdict(Html.strong(NAME), " is said.").note(NAME).soft(NAME);
    page.section(NAME).list(List.of(Html.of(NAME), Html.code(NAME)));
    page.add(Page.panel("", "Shares", new Bars().bar("one", 0.25, "after", "25 %").html()));
    page.pictures(
        List.of(
            new PagePicture("Bars", bars(), NAME),
            new PagePicture("Rows", rows(), NAME).with("As a table", table()),
            new PagePicture("Cells", cells(), NAME)));
    return page.html();
  }

  private static Html bars() {
    Graph graph = new Graph("Bars", new AxisScale(0, 3, 1), new AxisScale(0, 10, 5));
    graph.axes("place", "size");
    for (int i = 0; i < 3; i++) {
      graph.bar(i + 0.1, i + 0.9, 3 * (i + 1), "after", "bar " + i + " is " + 3 * (i + 1));
    }
    return graph.html();
  }

  private static Html rows() {
    Svg svg = new Svg(400, 200, "Rows").readAlong("rows", new Spot(50, 0), new Spot(350, 90));
    svg.curve(List.of(new Spot(50, 20), new Spot(200, 180), new Spot(350, 20)), 9, "table");
    return svg.html();
  }

  private static Table table() {
    Table table = Table.of("#bearing, degrees", "#error, cm").named("rows");
    for (int degrees = 0; degrees <= 90; degrees += 30) {
      table.row(degrees, "1." + degrees);
    }
    return table;
  }

  /** Two rings of four: right is bearing 90. */
  private static Html cells() {
    Svg svg = new Svg(200, 200, "Cells");
    svg.tell("centre", "100 100").tell("ring", "40").tell("metres", "0.5");
    svg.tell("cells", "1.5,2.5,,4.5;5.5,6.5,7.5,8.5");
    svg.circle(new Spot(100, 100), 80, "rim", "");
    return svg.html();
  }
}
