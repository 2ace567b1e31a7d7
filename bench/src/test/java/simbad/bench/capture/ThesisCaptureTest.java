package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableDocument;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

class ThesisCaptureTest {
  private static final Outline SQUARE =
      Outline.of(
          List.of(
              new Point(-0.01, -0.01),
              new Point(0.01, -0.01),
              new Point(0.01, 0.01),
              new Point(-0.01, 0.01)));

  private static TableDocument parse(String text, OptionalDouble temperatureC)
      throws DataFormatException {
    return ThesisCapture.parse(
        Path.of("numbers.txt"), text, new ThesisCapture.Meaning("post", SQUARE, temperatureC));
  }

  /** 49.5 steps of 118 us at 0 degrees C: 5841 us, 331.3 m/s, 0.9676 m; the surface is 1 cm out. */
  @Test
  void numbers_becomeDistancesToTheAxis() throws Exception {
    TableDocument table = parse("# mine\n49\n\r49\r\n0\n 98 \n", OptionalDouble.of(0));
    assertEquals(4, table.table().size());
    assertEquals(0.9776, table.table().valueM(0), 1e-4);
    assertEquals(0.0198, table.table().valueM(2), 1e-4);
    assertEquals(1.9253 + 0.01, table.table().valueM(3), 1e-3);
    assertEquals("captured", table.provenanceWord());
    assertTrue(table.header("temperature").orElse("").startsWith("0.0 degrees C: sound at 331.3"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "49;x;3 | numbers.txt:2: number: 'x' is not a number",
        "49;48;305 | numbers.txt:3: number: 305 steps are 36 ms",
        "49;48 | numbers.txt: 2 numbers, expected",
        "49;-1;2 | numbers.txt:2: number: '-1'"
      })
  void faults_areNamed(String text, String message) {
    DataFormatException fault =
        assertThrows(
            DataFormatException.class,
            () -> parse(text.replace(';', '\n'), OptionalDouble.empty()));
    assertTrue(String.valueOf(fault.getMessage()).startsWith(message), fault.getMessage());
  }
}
