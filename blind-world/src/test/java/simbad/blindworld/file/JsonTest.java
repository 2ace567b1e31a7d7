package simbad.blindworld.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {

  @Test
  void whatIsWritten_isReadBack() throws FormatException {
    Map<String, Object> value = new LinkedHashMap<>();
    value.put("text", "a \"quoted\" \\ line\nand a tab\t");
    value.put("numbers", List.of(1.5, -2.0, 0.0, 1e-9));
    value.put("empty", Map.of());
    value.put("yes", true);
    assertEquals(value, JsonReader.read("f", Json.write(value)));
  }

  @Test
  void otherWritersJson_isRead() throws FormatException {
    Object read = JsonReader.read("f", "\t{\"a\":[1e3,-0.5E-1,null,false],\"\\u00e4\\/\":{}}\r\n");
    assertEquals(
        Map.of("a", List.of(1000.0, -0.05, JsonReader.NULL, false), "\u00e4/", Map.of()), read);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "{",
        "[1,",
        "{\"a\" 1}",
        "nul",
        "[1] 2",
        "\"open",
        "{\"a\":1,,}",
        "[1.2.3]",
        "\"\\x\"",
        "\"\\u12\"",
        "[NaN]"
      })
  void brokenJson_isRefused(String text) {
    FormatException e = assertThrows(FormatException.class, () -> JsonReader.read("x.json", text));
    assertTrue(e.toString().contains("x.json, line 1: "), e.getMessage());
  }

  @Test
  void lineOfAFault_isNamed() {
    FormatException e =
        assertThrows(FormatException.class, () -> JsonReader.read("f", "{\n\"a\": 1,\n\"b\": x}"));
    assertTrue(e.toString().contains("f, line 3: found 'x'"), e.getMessage());
  }

  @Test
  void depthWithoutEnd_isRefused() {
    assertThrows(FormatException.class, () -> JsonReader.read("f", "[".repeat(100_000)));
  }

  @Test
  void infiniteNumbers_areNotWritten() {
    assertThrows(IllegalArgumentException.class, () -> Json.write(List.of(Double.NaN)));
  }

  @Test
  void fields_areAskedForByKind() throws FormatException {
    JsonObject json =
        JsonObject.parse("f", "{\"n\": 1, \"t\": \"x\", \"l\": [1, 2], \"big\": 1e999}");
    assertEquals(1, json.number("n"));
    assertEquals("x", json.text("t"));
    assertEquals(List.of(1.0, 2.0), json.numbers("l"));
    check("f, t: expected a number", () -> json.number("t"));
    check("f, missing: expected a text", () -> json.text("missing"));
    check("f, big: expected a finite number", () -> json.number("big"));
    check("f, n: 1.0, expected a number in [2.0, 3.0]", () -> json.within("n", 2, 3));
    check("f, l: expected a list of texts", () -> json.texts("l"));
    check("f, n: expected an object", () -> json.object("n"));
    check("f, l[0]: expected an object", () -> json.objects("l"));
    check("g: expected an object", () -> JsonObject.parse("g", "[]"));
  }

  private interface Reading {
    Object read() throws FormatException;
  }

  private static void check(String message, Reading reading) {
    assertEquals(message, assertThrows(FormatException.class, reading::read).getMessage());
  }
}
