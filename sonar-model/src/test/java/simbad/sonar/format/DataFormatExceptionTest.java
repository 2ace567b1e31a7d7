package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DataFormatExceptionTest {
  private static final Path FILE = Path.of("a", "b.csv");

  private static void check(String expected, DataFormatException fault) {
    assertEquals(expected, fault.getMessage());
  }

  @Test
  void message_saysWhere() {
    check(FILE + ": is bad", DataFormatException.inFile(FILE, "is bad"));
    check(FILE + ":7: x_m: is bad", DataFormatException.inField(FILE, 7, "x_m", "is bad"));
    check("--seed: is bad", DataFormatException.inArgument("--seed", "is bad"));
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {"`a\nb`, a b", "`a \r\n  b`, a b", "`a\u0000b`, a b", "`a\u2028b\u0085c`, a b c"})
  void message_isOneLine(String problem, String shown) {
    check("x: " + shown, DataFormatException.inArgument("x", problem));
    check(shown + ": x", DataFormatException.inArgument(problem, "x"));
    check(FILE + ":1: " + shown + ": x", DataFormatException.inField(FILE, 1, problem, "x"));
  }

  @Test
  void message_isCutInTheMiddle_whenItIsLong() {
    String begin = "'" + "a".repeat(1000);
    String message = DataFormatException.inArgument("x", begin + "' is not b").getMessage();
    String shown = String.valueOf(message);
    assertEquals("x: 'aaa", shown.substring(0, 7));
    assertEquals("a' is not b", shown.substring(shown.length() - 11));
    assertEquals(true, shown.length() < 400 && shown.contains("a...a"));
  }
}
