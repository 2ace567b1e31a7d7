package simbad.sonar.format;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Text files that are part of the program: one that is missing is a fault of the build. */
public final class ShippedText {
  private ShippedText() {}

  /**
   * Reads a file that lies beside a class, in UTF-8.
   *
   * @param beside a class of the jar that holds the file
   * @param name of the file, as {@link Class#getResourceAsStream} takes it
   * @return the whole text, byte for byte as it was built
   * @throws IllegalStateException if there is no such file
   */
  public static String read(Class<?> beside, String name) {
    try (InputStream in = beside.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException(name + " is not in the program");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(name + " cannot be read from the program", e);
    }
  }
}
