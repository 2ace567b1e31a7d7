package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import simbad.sonar.format.WholeFile;

/** A file of fitted constants, with where they come from. */
final class ConstantsFile {
  private static final MathContext DIGITS = new MathContext(4);
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final ObjectNode root = MAPPER.createObjectNode();

  /**
   * Begins one.
   *
   * @param format of the file
   */
  ConstantsFile(String format) {
    root.put("format", format);
  }

  /** Where constants come from. */
  static final class Origin {
    private final ObjectNode node = MAPPER.createObjectNode();
    private final ArrayNode checks;

    /**
     * Begins one.
     *
     * @param how the program that fits
     * @param date that the file shall say
     */
    Origin(String how, String date) {
      node.put("how", how);
      node.put("date", date);
      checks = node.putArray("checks");
    }

    /** Notes a check and how many of its cases counted, and returns the note; none is no origin. */
    ObjectNode add(Path check, int cases) throws IOException {
      ObjectNode one = cases > 0 ? checks.addObject() : MAPPER.createObjectNode();
      one.set("order", MAPPER.readTree(Files.readString(check.resolve("order.json"))));
      one.put("cases", cases);
      return one;
    }

    /** Keeps a note of an earlier file. */
    void keep(JsonNode note) {
      checks.add(note);
    }

    /** Returns its node, to which more may be put. */
    ObjectNode node() {
      return node;
    }
  }

  /** Returns the node of the constants. */
  ObjectNode root() {
    return root;
  }

  void write(Path file) throws IOException {
    String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
    WholeFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  /** Puts numbers of four digits. */
  static void put(ObjectNode node, Map<String, Double> values) {
    values.forEach((name, value) -> node.put(name, rounded(value)));
  }

  static double rounded(double value) {
    return new BigDecimal(value).round(DIGITS).doubleValue();
  }
}
