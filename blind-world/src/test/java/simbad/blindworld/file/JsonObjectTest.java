package simbad.blindworld.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Fields by name and kind, how values are written to the byte, and hashes over many. */
class JsonObjectTest {

  private static JsonObject parse(String text) throws FormatException {
    return JsonObject.parse("f", text);
  }

  @Test
  void nothing_isNoField() throws FormatException {
    JsonObject json = parse("{\"a\": null, \"b\": 2, \"c\": false}");
    assertFalse(json.has("a"));
    assertTrue(json.has("b"));
    assertTrue(json.has("c"));
    assertFalse(json.has("d"));
    assertEquals(Optional.empty(), json.optionalNumber("a"));
    assertEquals(Optional.of(2.0), json.optionalNumber("b"));
    assertEquals(Optional.empty(), json.optionalNumber("d"));
  }

  /** As JSON's null stands in a list. */
  @Test
  void listWithANull_isKnown() throws FormatException {
    JsonObject json = parse("{\"a\": [1, null], \"b\": [1, 2], \"c\": []}");
    assertTrue(json.hasNull("a"));
    assertFalse(json.hasNull("b"));
    assertFalse(json.hasNull("c"));
    assertThrows(FormatException.class, () -> json.hasNull("d"));
    assertThrows(FormatException.class, () -> json.numbers("a"));
  }

  @Test
  void interval_hasItsEnds() throws FormatException {
    JsonObject json = parse("{\"a\": 2}");
    assertEquals(2, json.within("a", 2, 3));
    assertEquals(2, json.within("a", 1, 2));
    assertThrows(FormatException.class, () -> json.within("a", 2.5, 3));
    assertThrows(FormatException.class, () -> json.within("a", 1, 1.5));
  }

  @Test
  void listsAndObjects_areReadInTheirOrder() throws FormatException {
    JsonObject json =
        parse(
            """
            {"o": {"n": 1}, "os": [{"n": 2}, {"n": 3}], "t": ["b", "a"],
             "nn": [[1, 2], []], "tt": [["x"], ["y", "z"]]}
            """);
    assertEquals(1, json.object("o").number("n"));
    assertEquals("f, o", json.object("o").where());
    assertEquals(2, json.objects("os").size());
    assertEquals(3, json.objects("os").get(1).number("n"));
    assertEquals("f, os[1]", json.objects("os").get(1).where());
    assertEquals(List.of("b", "a"), json.texts("t"));
    assertEquals(List.of(List.of(1.0, 2.0), List.of()), json.numberLists("nn"));
    assertEquals(List.of(List.of("x"), List.of("y", "z")), json.textLists("tt"));
    assertThrows(FormatException.class, () -> json.numberLists("tt"));
    assertThrows(FormatException.class, () -> json.textLists("t"));
  }

  @Test
  void file_isNamed(@TempDir Path folder) throws IOException, FormatException {
    Path file = Files.writeString(folder.resolve("a.json"), "{\"n\": 1}");
    assertEquals(1, JsonObject.read(file).number("n"));
    assertEquals(file.toString(), JsonObject.read(file).where());
    Path csv = Files.writeString(folder.resolve("a.csv"), "a\n 7 \n");
    assertEquals(7, Csv.read(csv).number(0, 0));
  }

  @Test
  void text_isIndentedBySteps() {
    Map<String, Object> inner = new LinkedHashMap<>();
    inner.put("b", List.of(1, 2L));
    inner.put("a", true);
    Map<String, Object> value = new LinkedHashMap<>();
    value.put("z", inner);
    value.put("e", List.of());
    assertEquals(
        """
        {
         "z": {
          "b": [
           1,
           2
          ],
          "a": true
         },
         "e": []
        }
        """,
        Json.write(value));
    assertEquals("\"a\\\"\\\\\\u000a b\"\n", Json.write("a\"\\\n b"));
  }

  /** To nine decimals, without needless noughts, and never minus nothing. */
  @ParameterizedTest
  @CsvSource({
    "1.5, 1.5",
    "2, 2.0",
    "100, 100.0",
    "0.1234567891, 0.123456789",
    "-1e-12, 0.0",
    "-3.25, -3.25",
  })
  void numbers_areWrittenShortly(double value, String expected) {
    assertEquals(expected, Json.number(value));
  }

  @ParameterizedTest
  @CsvSource({
    "1.25, 1, 1.3",
    "-1.25, 3, -1.250",
    "0.0004, 3, 0.000",
    "0.9996, 3, 1.000",
    "12.05, 2, 12.05",
    "-0.5, 1, -0.5",
  })
  void decimals_areAllWritten(double value, int decimals, String expected) {
    assertEquals(expected, Decimals.append(new StringBuilder(), value, decimals).toString());
  }

  @Test
  void escapes_areRead() throws FormatException {
    assertEquals(
        "\"\\/\b\f\n\r\t\u00e9!", JsonReader.read("f", "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9!\""));
    assertEquals(List.of(true, false, 0.0, 9.0), JsonReader.read("f", "[true,false,0,9]"));
    assertEquals(Map.of("a", List.of()), JsonReader.read("f", " { \"a\" : [ ] } "));
  }

  /** 199 lists may stand in one another, with a value in the innermost, and beside each other. */
  @Test
  void depth_isCountedByLevels() throws FormatException {
    JsonReader.read("f", "[".repeat(199) + "1" + "]".repeat(199));
    assertThrows(
        FormatException.class, () -> JsonReader.read("f", "[".repeat(200) + "1" + "]".repeat(200)));
    JsonReader.read("f", "[" + "[1],".repeat(500) + "1]");
  }

  private static void assertFault(String expected, String text) {
    FormatException fault = assertThrows(FormatException.class, () -> JsonReader.read("f", text));
    assertEquals("f, line " + expected, fault.getMessage());
  }

  @Test
  void faults_sayWhatWasFoundAndWhere() {
    assertFault("1: found the end of the file, expected ','", "[1");
    assertFault("1: found '2', expected ','", "[1 2]");
    assertFault("1: found 'x', expected a value", "x");
    assertFault("4: found 'x', expected a value", "[\n1,\n\nx]");
    assertFault("4: found 'x', expected a value", "[\n1,\n\n  x]");
    assertFault("2: found the end of the file, expected ','", "[1\n");
  }

  private static String both(String left, String right) {
    return Seal.sha256((left + right).getBytes(StandardCharsets.US_ASCII));
  }

  /** Pairs of neighbours, level by level; what is left over is paired with itself. */
  @Test
  void root_isThatOfATree() throws FormatException {
    assertEquals(both("a", "b"), Seal.root(List.of("a", "b")));
    assertEquals(both(both("a", "b"), both("c", "c")), Seal.root(List.of("a", "b", "c")));
    assertEquals(
        both(both(both("a", "b"), both("c", "d")), both(both("e", "e"), both("e", "e"))),
        Seal.root(List.of("a", "b", "c", "d", "e")));
    assertEquals(Seal.sha256(new byte[0]), Seal.root(List.of()));
    assertEquals("00ff10", Seal.hex(new byte[] {0, -1, 16}));
    assertArrayEquals(new byte[] {0, -1, 16}, Seal.bytes(" 00ff10\n"));
  }

  /** Of a comma, a doubled quotation mark and a blank line inside and outside of quotes. */
  @Test
  void csvFields_mayBeQuoted() throws FormatException {
    Csv csv = Csv.parse("f", "\"a,b\",c\n\"\"\"\",\n \n,\"x\"\"y\"\n");
    assertEquals(List.of("a,b", "c"), csv.header());
    assertEquals(2, csv.size());
    assertEquals("\"", csv.text(0, 0));
    assertEquals("", csv.text(0, 1));
    assertEquals("x\"y", csv.text(1, 1));
    assertEquals(0, csv.column("a,b"));
  }
}
