package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a report's colours tell apart, they tell apart to the colour-blind too, or a dash does. */
class PageColoursTest {
  private static final List<String> TRACES =
      List.of("table", "edge", "original", "shadow", "overlap", "ray", "noisy", "level", "other");
  private static final double WIDER = 1.5;

  private static String css() throws IOException {
    try (InputStream in =
        Objects.requireNonNull(PageColoursTest.class.getResourceAsStream("page.css"))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static Map<String, Color> colours(boolean dark) throws IOException {
    return ColourSight.palette(css(), dark);
  }

  /** The first three of Sharma's pairs, one of two greys, and one round the hue's seam. */
  @ParameterizedTest
  @CsvSource({
    "50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425",
    "50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615",
    "50, 2.8361, -74.0200, 50, 0, -82.7485, 3.4412",
    "50, 0, 0, 50, -1, 2, 2.3669",
    "22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373",
    "50, 2.4900, -0.0010, 50, -2.4900, 0.0011, 7.2195"
  })
  void differences_areSharmas(
      double l1, double a1, double b1, double l2, double a2, double b2, double difference) {
    assertEquals(
        difference,
        ColourSight.difference(new double[] {l1, a1, b1}, new double[] {l2, a2, b2}),
        1e-4);
  }

  /** A red and a green that everybody knows to be one to many; black and white are two to all. */
  @Test
  void redAndGreen_areAlikeToSome() {
    assertTrue(
        ColourSight.difference(new Color(0xB05030), new Color(0x707028)) < ColourSight.LEAST);
    assertEquals(100, ColourSight.difference(Color.BLACK, Color.WHITE), 0.1);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void bars_areToldApart(boolean dark) throws IOException {
    Map<String, Color> colours = new HashMap<>(colours(dark));
    Matcher effects = Pattern.compile("\\.(effect\\d) \\{ background: (#\\w{6})").matcher(css());
    effects.results().forEach(e -> colours.put(e.group(1), ColourSight.colour(e.group(2))));
    assertEquals(
        List.of(), ColourSight.alike(colours, "effect0", "effect1", "effect2", "unknown", "floor"));
    assertEquals(List.of(), ColourSight.alike(colours, "before", "after", "floor", "unknown"));
    assertEquals(List.of(), ColourSight.alike(colours, "after", "alarm", "ink"));
  }

  private static Color of(Map<String, Color> colours, String name) {
    return Objects.requireNonNull(colours.get(name), name);
  }

  /** Darker, or brighter, all the way: so it orders to all eyes. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void shades_areInOrder(boolean dark) throws IOException {
    Map<String, Color> colours = colours(dark);
    for (int shade = 1; shade <= 8; shade++) {
      double[] before = ColourSight.lightness(of(colours, "h" + (shade - 1)));
      double[] after = ColourSight.lightness(of(colours, "h" + shade));
      for (int eye = 0; eye < before.length; eye++) {
        double step = dark ? after[eye] - before[eye] : before[eye] - after[eye];
        assertTrue(step > 2, "h" + shade + " to eye " + eye + ": " + step);
      }
    }
  }

  /** Lines differ in colour, dash or width. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void traces_areToldApart(boolean dark) throws IOException {
    List<Line> lines = new ArrayList<>();
    for (String name : TRACES) {
      lines.add(line(name, colours(dark)));
    }
    for (Line one : lines) {
      for (Line other : lines.subList(lines.indexOf(one) + 1, lines.size())) {
        boolean differ =
            !one.dash().equals(other.dash())
                || Math.max(one.width(), other.width())
                    >= WIDER * Math.min(one.width(), other.width())
                || ColourSight.difference(one.colour(), other.colour()) >= ColourSight.LEAST;
        assertTrue(differ, one + " and " + other);
      }
    }
  }

  private record Line(String name, Color colour, String dash, double width) {}

  private static Line line(String name, Map<String, Color> colours) throws IOException {
    Matcher rule = Pattern.compile("svg \\." + name + " \\{([^}]*)}").matcher(css());
    assertTrue(rule.find(), name);
    String colour = value(rule.group(1), "stroke", "").replaceAll("var\\(--(\\w+)\\)", "$1");
    double width = Double.parseDouble(value(rule.group(1), "stroke-width", "1.8"));
    return new Line(name, of(colours, colour), value(rule.group(1), "stroke-dasharray", ""), width);
  }

  private static String value(String rule, String property, String otherwise) {
    Matcher found = Pattern.compile("(?:^|;)\\s*" + property + ": ([^;]+)").matcher(rule);
    return found.find() ? found.group(1).strip() : otherwise;
  }
}
