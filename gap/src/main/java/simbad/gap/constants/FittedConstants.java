package simbad.gap.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Objects;

/** Reads files of fitted constants. */
public final class FittedConstants {
  private static final String FILE = "constants.json";

  private FittedConstants() {}

  /**
   * Returns the file that stands beside a class.
   *
   * @param beside whose constants they are
   */
  public static JsonNode of(Class<?> beside) {
    try (InputStream file = beside.getResourceAsStream(FILE)) {
      return new ObjectMapper().readTree(Objects.requireNonNull(file, FILE));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Refuses a file of another format.
   *
   * @param root of the file
   * @param format that is expected
   * @throws IllegalArgumentException if it has another one, or none
   */
  public static void check(JsonNode root, String format) {
    String own = root.path("format").asText();
    if (!format.equals(own)) {
      throw new IllegalArgumentException("format: \"" + own + "\" is not \"" + format + '"');
    }
  }

  /**
   * Returns a number.
   *
   * @param parent node that has it
   * @param field its name
   * @throws IllegalArgumentException if it is missing or no number
   */
  public static double number(JsonNode parent, String field) {
    if (!parent.path(field).isNumber()) {
      throw new IllegalArgumentException(field + ": " + parent.path(field) + " is not a number");
    }
    return parent.get(field).doubleValue();
  }
}
