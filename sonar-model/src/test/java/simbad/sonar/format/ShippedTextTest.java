package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class ShippedTextTest {
  @Test
  void missingFile_isNamed() {
    IllegalStateException fault =
        assertThrows(
            IllegalStateException.class, () -> ShippedText.read(ShippedTextTest.class, "none.txt"));
    assertEquals("none.txt is not in the program", fault.getMessage());
  }

  @Test
  void file_isReadWhole() throws Exception {
    String name = "/junit-platform.properties";
    Path file = Path.of("src/test/resources" + name);
    assertEquals(Files.readString(file), ShippedText.read(ShippedTextTest.class, name));
  }
}
