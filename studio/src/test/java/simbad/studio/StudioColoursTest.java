package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.figures.page.ColourSight;

/** What the studio's colours tell apart, they tell apart to the colour-blind too. */
class StudioColoursTest {
  private static String read(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StudioColoursTest.class.getResourceAsStream("page/" + name))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static Map<String, Color> colours(boolean dark) throws IOException {
    Map<String, Color> colours = new LinkedHashMap<>();
    for (String sheet : List.of("studio.css", "watch.css")) {
      colours.putAll(ColourSight.palette(read(sheet), dark));
    }
    return colours;
  }

  /**
   * Parts of a gap, effects of a diagnosis, dots of its rows: nothing but colour tells them apart.
   */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void fillsAndDots_areToldApart(boolean dark) throws IOException {
    Map<String, Color> colours = colours(dark);
    assertEquals(List.of(), ColourSight.alike(colours, "c0", "c4", "c2", "c3", "quiet"));
    assertEquals(List.of(), ColourSight.alike(colours, "c1", "c0", "quiet"));
    assertEquals(List.of(), ColourSight.alike(colours, "c0", "c1", "c2", "c3", "c4", "c5"));
    assertEquals(List.of(), ColourSight.alike(colours, "low", "high", "c3", "soft"));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theLiveWorld_isToldApart(boolean dark) throws IOException {
    Map<String, Color> colours = colours(dark);
    assertEquals(
        List.of(), ColourSight.alike(colours, "edge", "trail", "heard", "quiet", "body", "paper"));
    assertEquals(List.of(), ColourSight.alike(colours, "robot", "trail", "heard", "edge"));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aCapture_isToldApart(boolean dark) throws IOException {
    Map<String, Color> colours = colours(dark);
    assertEquals(List.of(), ColourSight.alike(colours, "edge", "interval", "heard", "open"));
    assertEquals(List.of(), ColourSight.alike(colours, "good", "alarm"));
  }

  /** Lines of a chart may come near each other in colour: each has a dash of its own. */
  @Test
  void linesOfAChart_haveDashesOfTheirOwn() throws IOException {
    Matcher dashes = Pattern.compile("DASHES = \\[(.*)];").matcher(read("sheet.js"));
    assertEquals(true, dashes.find());
    List<String> each = List.of(dashes.group(1).split("(?<=]), "));
    assertEquals(6, each.size(), each.toString());
    assertEquals(each.size(), each.stream().distinct().count());
  }
}
