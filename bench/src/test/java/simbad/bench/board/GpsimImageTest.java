package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.DataFormatException;

class GpsimImageTest {
  @TempDir Path folder = Path.of("");

  private String read(String records) throws Exception {
    return GpsimImage.read(Files.writeString(folder.resolve("p.hex"), records));
  }

  /** Filled up to whole words; the records of the program are left as they are. */
  @Test
  void configuration_isFilledUpToWords() throws Exception {
    String program = ":020000040000FA :0300010011223396 :020000040030CA ";
    String end = " :00000001FF";
    assertEquals(
        lines(program + ":04000000FF08020FE4 :04000400FF8181FFF8" + end),
        read(lines(program + ":0300010008020FE3 :020005008181F7" + end)));
  }

  private static String lines(String records) {
    return records.replace(' ', '\n') + "\n";
  }

  @ParameterizedTest
  @CsvSource({"hello", ":0300010008020FE4", ":0400010008020FE2", ":03", "''"})
  void badRecord_isNamed(String record) {
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> read(":020000040030CA\n" + record + "\n"));
    assertTrue(String.valueOf(fault.getMessage()).contains("p.hex:2: record: "));
  }
}
