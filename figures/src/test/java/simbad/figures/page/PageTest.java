package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.figures.page.Svg.Spot;

class PageTest {
  private static final String PAGE = SamplePage.html();

  /** A name that ends the script, or begins an element, does neither. */
  @Test
  void names_stayText() {
    assertEquals(1, PAGE.split("</script>", -1).length - 1);
    assertFalse(PAGE.contains("<b>a"));
    assertEquals(
        11, PAGE.split(Pattern.quote("&lt;/script&gt;&lt;b&gt;a &amp; &quot;b"), -1).length - 1);
  }

  /** What the browser is told to run is what stands there, and nothing is fetched. */
  @Test
  void policy_allowsThePagesOwnScriptAlone() throws Exception {
    Matcher script = Pattern.compile("(?s)<script>(.*)</script>").matcher(PAGE);
    assertTrue(script.find());
    byte[] hash =
        MessageDigest.getInstance("SHA-256")
            .digest(script.group(1).getBytes(StandardCharsets.UTF_8));
    String policy =
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-"
            + Base64.getEncoder().encodeToString(hash)
            + "'; base-uri 'none'; form-action 'none'";
    assertTrue(PAGE.contains("http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\""));
    assertFalse(Pattern.compile("src=|url\\(|@import|<link").matcher(PAGE).find());
  }

  @Test
  void text_keepsItsUnitWithItsNumber() {
    assertEquals("5&nbsp;cm", Html.of("5\u00a0cm").toString());
    assertEquals("<strong>a&lt;b</strong>1", Html.of(Html.strong("a<b"), 1).toString());
  }

  @Test
  void row_ofAnotherLength_isRefused() {
    Table table = Table.of("one", "#two");
    assertThrows(IllegalArgumentException.class, () -> table.row("1"));
    assertTrue(
        table.row("<1>", 2).html().toString().contains("<td>&lt;1&gt;</td><td class=\"n\">2</td>"));
  }

  /** A thousand corners of a straight line are two. */
  @Test
  void curve_keepsTheCornersThatItNeeds() {
    List<Spot> line = IntStream.range(0, 1000).mapToObj(i -> new Spot(i / 10.0, 7)).toList();
    Svg svg = new Svg(100, 100, "line");
    svg.curve(line, 1000, "table");
    assertTrue(svg.html().toString().contains("d=\"M0 140l1998 0\""), svg.html().toString());
  }

  @Test
  void curve_ofTooManyCorners_isCoarser() {
    List<Spot> zigzag =
        IntStream.range(0, 1000).mapToObj(i -> new Spot(i / 10.0, i % 2 * 3)).toList();
    Svg svg = new Svg(100, 100, "zigzag");
    svg.curve(zigzag, 20, "table");
    assertTrue(svg.html().toString().split("l", -1).length < 40, svg.html().toString());
  }

  @Test
  void samePage_sameBytes() {
    assertEquals(PAGE, SamplePage.html());
  }
}
