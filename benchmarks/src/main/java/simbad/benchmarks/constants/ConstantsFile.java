package simbad.benchmarks.constants;

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
  private final ObjectNode origin;
  private final ArrayNode checks;

  /**
   * Begins one.
   *
   * @param format of the file
   * @param how the program that fits
   * @param date that the file shall say
   */
  ConstantsFile(String format, String how, String date) {
    root.put("format", format);
    origin = root.putObject("origin");
    origin.put("how", how);
    origin.put("date", date);
    checks = origin.putArray("checks");
  }

  /** Notes a check and how many of its cases counted. */
  void add(Path check, int cases) throws IOException {
    ObjectNode node = checks.addObject();
    node.set("order", MAPPER.readTree(Files.readString(check.resolve("order.json"))));
    node.put("cases", cases);
  }

  /** Returns the node of the constants. */
  ObjectNode root() {
    return root;
  }

  /** Returns the node of where they come from. */
  ObjectNode origin() {
    return origin;
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
