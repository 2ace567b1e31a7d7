package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Bad files are refused in one line that says where and what. */
public final class Faults {
  /** More than a terminal's few lines helps nobody, and a bad file may hold megabytes. */
  private static final int LONGEST = 500;

  private Faults() {}

  /** Any of the readers. */
  @FunctionalInterface
  public interface Reader {
    Object read(Path file) throws DataFormatException;
  }

  public static Path file(Path directory, String text) throws IOException {
    return file(directory, text.getBytes(StandardCharsets.UTF_8));
  }

  public static Path file(Path directory, byte[] bytes) throws IOException {
    return Files.write(directory.resolve("input.txt"), bytes);
  }

  /**
   * The file is refused.
   *
   * @param where what stands between the file's name and the problem, such as ":3: threshold_m: "
   * @param parts of the problem
   */
  public static void check(Reader reader, Path file, String where, String... parts) {
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> reader.read(file), () -> "expected " + where);
    String message = String.valueOf(fault.getMessage());
    checkForm(message, file);
    assertTrue(message.startsWith(file + where), message + " starts with " + where);
    for (String part : parts) {
      assertTrue(message.contains(part), message + " holds " + part);
    }
  }

  public static void checkForm(String message, Path file) {
    assertTrue(message.startsWith(file + ":"), message + " names its file");
    assertEquals(0, message.chars().filter(Faults::breaksLine).count(), "one line: " + message);
    assertTrue(message.length() < LONGEST + file.toString().length(), message);
  }

  private static boolean breaksLine(int c) {
    return Character.isISOControl(c) || c == 0x2028 || c == 0x2029;
  }
}
