package simbad.blindworld.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class CsvAndSealTest {

  @Test
  void quotedFieldsAndBlankLines_areRead() throws FormatException {
    Csv csv = Csv.parse("f", "a,b\r\n\n\"x, \"\"y\"\"\",2.5\n");
    assertEquals(List.of("a", "b"), csv.header());
    assertEquals("x, \"y\"", csv.text(0, 0));
    assertEquals(2.5, csv.number(0, csv.column("b")));
  }

  @Test
  void faultsNameFileLineAndField() throws FormatException {
    Csv csv = Csv.parse("f.csv", "a,b\n1,2\n3,1,5\n".replace(",5", ""));
    assertEquals(2, csv.size());
    check("f.csv, line 1: no column 'c'", () -> csv.column("c"));
    check("f, line 2: 3 fields, expected 2", () -> Csv.parse("f", "a,b\n1,2,3"));
    check("f, line 1: nothing, expected a header", () -> Csv.parse("f", "\n"));
    check("f, line 2, a: 'NaN', expected a number", () -> Csv.parse("f", "a\nNaN").number(0, 0));
    check("f, line 2, a: 'x', expected a number", () -> Csv.parse("f", "a\nx").number(0, 0));
  }

  private interface Reading {
    Object read() throws FormatException;
  }

  private static void check(String message, Reading reading) {
    assertEquals(message, assertThrows(FormatException.class, reading::read).getMessage());
  }

  @Test
  void decimals_areRounded() {
    assertEquals("-0.1250", Decimals.append(new StringBuilder(), -0.12499999, 4).toString());
    assertEquals("3.000", Decimals.append(new StringBuilder(), 2.9996, 3).toString());
    assertEquals("0.000", Decimals.append(new StringBuilder(), -0.0001, 3).toString());
  }

  /** The digest of the empty message (FIPS 180-4, as every implementation prints it). */
  @Test
  void sha256_isSha256() {
    assertEquals(
        "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855",
        Seal.sha256(new byte[0]));
    assertEquals(
        Seal.sha256("saltytruth".getBytes(StandardCharsets.US_ASCII)),
        Seal.commitment(
            "salty".getBytes(StandardCharsets.US_ASCII),
            "truth".getBytes(StandardCharsets.US_ASCII)));
  }

  @Test
  void root_dependsOnEveryLeafAndTheirOrder() {
    String root = Seal.root(List.of("a", "b", "c"));
    assertNotEquals(root, Seal.root(List.of("a", "c", "b")));
    assertNotEquals(root, Seal.root(List.of("a", "b", "d")));
    assertEquals("a", Seal.root(List.of("a")));
  }

  @Test
  void saltThatIsNotHexadecimal_isRefused() {
    check("salt: 'xyz', expected hexadecimal digits", () -> Seal.bytes("xyz"));
  }
}
