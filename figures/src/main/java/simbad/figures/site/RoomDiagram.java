package simbad.figures.site;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import simbad.figures.markup.Markup;

/**
 * The rooms of the project and who uses whom, drawn from the poms: an arrow is a dependency that a
 * room's pom names, less those that follow from two other arrows.
 *
 * <p>Where a box stands is laid out by hand, so that every arrow is a line straight down.
 */
public final class RoomDiagram {
  private static final int COLUMN = 208;
  private static final int ROW = 146;
  private static final int HEIGHT = 104;
  private static final int GAP = 16;
  private static final int LINE = 16;
  private static final int LETTERS = 27;

  /** A box: its row from above, its first column, and how many it spans. */
  private record Place(int row, int column, int span) {
    int left() {
      return GAP + column * COLUMN;
    }

    int width() {
      return span * COLUMN - GAP;
    }

    int top() {
      return GAP + row * ROW;
    }

    /** The middle of the columns that both boxes stand in. */
    int meets(Place other) {
      int from = Math.max(left(), other.left());
      int to = Math.min(left() + width(), other.left() + other.width());
      return (from + to) / 2;
    }
  }

  private static final Map<String, Place> PLACES =
      Map.ofEntries(
          Map.entry("python", new Place(0, 3, 2)),
          Map.entry("cluster", new Place(0, 5, 2)),
          Map.entry("benchmarks", new Place(2, 0, 3)),
          Map.entry("cli", new Place(1, 3, 4)),
          Map.entry("studio", new Place(2, 3, 4)),
          Map.entry("figures", new Place(3, 0, 7)),
          Map.entry("experiments", new Place(4, 0, 7)),
          Map.entry("gap", new Place(5, 0, 3)),
          Map.entry("obstacles", new Place(5, 3, 1)),
          Map.entry("effects", new Place(6, 0, 2)),
          Map.entry("motion-model", new Place(6, 2, 1)),
          Map.entry("simbad-core", new Place(6, 3, 1)),
          Map.entry("scattering", new Place(6, 4, 1)),
          Map.entry("bench", new Place(6, 5, 1)),
          Map.entry("definitions", new Place(7, 0, 1)),
          Map.entry("sonar-model", new Place(7, 1, 5)),
          Map.entry("blind-world", new Place(7, 6, 1)));

  private static final String HEAD =
      """
      <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %1$d %2$d" width="%1$d" height="%2$d" role="img" aria-label="%3$s">
      <!-- Drawn from the poms by the option figures of simbad docs. -->
      <style>
      .paper { fill: #fff; } .room { fill: #f2f4f6; stroke: #6b7680; }
      .use { stroke: #3a4650; stroke-width: 1.6; fill: none; marker-end: url(#tip); }
      .process { stroke-dasharray: 6 4; } #tip path { fill: #3a4650; }
      text { font: 13px system-ui, "DejaVu Sans", sans-serif; fill: #1a1a1a; text-anchor: middle; } .name { font-weight: bold; font-size: 15px; }
      @media (prefers-color-scheme: dark) {
        .paper { fill: #15181b; } .room { fill: #23282d; stroke: #7d8894; } text { fill: #e6e6e6; }
        .use { stroke: #b9c4cf; } #tip path { fill: #b9c4cf; }
      }
      </style>
      <defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto"><path d="M0 0 8 4 0 8Z"/></marker></defs>
      <rect class="paper" width="%1$d" height="%2$d"/>
      """;

  private RoomDiagram() {}

  /**
   * Draws the rooms.
   *
   * @param project the project's folder, whose poms are read
   * @return the picture as SVG, for light and dark pages
   * @throws IOException if a pom cannot be read, or a room has no place in the picture
   */
  public static String svg(Path project) throws IOException {
    List<Room> rooms = Room.readAll(project);
    StringBuilder svg = new StringBuilder();
    int width = 7 * COLUMN + GAP;
    int height = 7 * ROW + HEIGHT + 2 * GAP;
    svg.append(HEAD.formatted(width, height, "The rooms and who uses whom"));
    for (Room room : rooms) {
      Place place = place(room.name());
      drawBox(svg, room, place);
      for (Room.Use use : Room.drawn(room, rooms)) {
        drawArrow(svg, room.name(), place, use);
      }
    }
    return svg.append("</svg>\n").toString();
  }

  private static Place place(String room) throws IOException {
    Place place = PLACES.get(room);
    if (place == null) {
      throw new IOException(room + ": RoomDiagram has no place for this room");
    }
    return place;
  }

  private static void drawBox(StringBuilder svg, Room room, Place place) {
    int middle = place.left() + place.width() / 2;
    svg.append(
        "<rect class=\"room\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"6\"/>\n"
            .formatted(place.left(), place.top(), place.width(), HEIGHT));
    List<String> lines = room.lines(LETTERS * place.span());
    int baseline = place.top() + (HEIGHT - LINE * (lines.size() + 1)) / 2 + 12;
    text(svg, "class=\"name\" ", middle, baseline, room.name());
    for (String line : lines) {
      baseline += LINE;
      text(svg, "", middle, baseline + 3, line);
    }
  }

  private static void text(StringBuilder svg, String style, int x, int y, String words) {
    svg.append(
        "<text %sx=\"%d\" y=\"%d\">%s</text>\n".formatted(style, x, y, Markup.escaped(words)));
  }

  private static void drawArrow(StringBuilder svg, String from, Place place, Room.Use use)
      throws IOException {
    Place target = place(use.room());
    svg.append(
        "<path class=\"use%s\" d=\"M%d %dV%d\"><title>%s uses %s</title></path>\n"
            .formatted(
                use.asProcess() ? " process" : "",
                place.meets(target),
                place.top() + HEIGHT,
                target.top() - 2,
                from,
                use.room()));
  }
}
