package simbad.sonar.format;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoublePredicate;

/**
 * A value of a JSON file that knows where it stands, so that a fault can be named to the line.
 *
 * <p>What asks for something that is not there, or of another kind, throws a {@link
 * DataFormatException}.
 */
public final class JsonInput {
  /** In any unit of these files, what is more is a slip. */
  static final double GREATEST = 1e6;

  private static final String UP_TO = ", up to 1e6";

  private static final ObjectMapper MAPPER =
      JsonMapper.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  private final Path file;
  private final Map<String, Integer> lines;
  private final String pointer;
  private final JsonNode node;

  private JsonInput(Path file, Map<String, Integer> lines, String pointer, JsonNode node) {
    this.file = file;
    this.lines = lines;
    this.pointer = pointer;
    this.node = node;
  }

  /**
   * Reads a file.
   *
   * @throws DataFormatException if it cannot be read or is no JSON
   */
  public static JsonInput read(Path file) throws DataFormatException {
    return parse(file, TextFile.read(file));
  }

  /**
   * Reads a value from a text that was read already.
   *
   * @param file how messages name the text
   * @param text JSON
   * @throws DataFormatException if it is no JSON, or has a field twice
   */
  public static JsonInput parse(Path file, String text) throws DataFormatException {
    if (text.isBlank()) {
      throw DataFormatException.inFile(file, "is empty, expected a JSON object");
    }
    try {
      JsonNode root = MAPPER.readTree(text);
      return new JsonInput(file, lines(text), "", root);
    } catch (MismatchedInputException e) {
      throw inJson(file, e, "text after the end of the JSON value");
    } catch (JsonProcessingException e) {
      throw inJson(file, e, e.getOriginalMessage());
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
  }

  /** The parser does not say where a limit of its own was exceeded. */
  private static DataFormatException inJson(Path file, JsonProcessingException e, String problem) {
    JsonLocation at = e.getLocation();
    return DataFormatException.inField(file, at == null ? 1 : at.getLineNr(), "JSON", problem);
  }

  private static Map<String, Integer> lines(String text) throws IOException {
    Map<String, Integer> lines = new HashMap<>();
    try (JsonParser parser = MAPPER.createParser(text)) {
      while (parser.nextToken() != null) {
        if (parser.currentToken() != JsonToken.FIELD_NAME) {
          lines.putIfAbsent(
              parser.getParsingContext().pathAsPointer().toString(),
              parser.currentTokenLocation().getLineNr());
        }
      }
    }
    return lines;
  }

  /** Returns a field of an object. */
  public JsonInput field(String name) throws DataFormatException {
    if (!node.isObject()) {
      throw fault(node + " is not an object");
    }
    if (!node.has(name)) {
      throw fault(name, "is missing");
    }
    return new JsonInput(file, lines, below(name), node.get(name));
  }

  /** Returns the items of a field that is a list. */
  public List<JsonInput> items(String field) throws DataFormatException {
    return field(field).items();
  }

  /** Returns the items of a list. */
  public List<JsonInput> items() throws DataFormatException {
    if (!node.isArray()) {
      throw fault(node + " is not a list");
    }
    List<JsonInput> items = new ArrayList<>();
    for (int i = 0; i < node.size(); i++) {
      items.add(new JsonInput(file, lines, pointer + "/" + i, node.get(i)));
    }
    return items;
  }

  /** Tells whether it is an object with that field. */
  public boolean has(String field) {
    return node.has(field);
  }

  /** Tells whether it is a list. */
  public boolean isList() {
    return node.isArray();
  }

  /** Returns the names of the fields of an object. */
  public List<String> names() throws DataFormatException {
    if (!node.isObject()) {
      throw fault(node + " is not an object");
    }
    List<String> names = new ArrayList<>();
    node.fieldNames().forEachRemaining(names::add);
    return names;
  }

  /** Returns a field that is a text. */
  public String text(String field) throws DataFormatException {
    return field(field).text();
  }

  /** Returns a text of at most {@value OneLine#LONGEST_TEXT} characters. */
  public String text() throws DataFormatException {
    if (!node.isTextual()) {
      throw fault(node + " is not a text");
    }
    String text = node.textValue();
    if (text.length() > OneLine.LONGEST_TEXT) {
      throw fault(text.length() + " characters, expected at most " + OneLine.LONGEST_TEXT);
    }
    return text;
  }

  /** Returns a field that is a name: it is printed, drawn and written into other files' lines. */
  String label(String field) throws DataFormatException {
    String name = text(field);
    if (!OneLine.isName(name)) {
      throw field(field).isNot(OneLine.NAME);
    }
    return name;
  }

  /** Tells whether this is a certain text. */
  public boolean isText(String text) {
    return text.equals(node.textValue());
  }

  double number(String field, DoublePredicate valid, String expected) throws DataFormatException {
    return field(field).number(valid, expected);
  }

  /**
   * Returns a number.
   *
   * @param valid false for all that is out of range
   * @param expected what a valid number is, for the message
   */
  public double number(DoublePredicate valid, String expected) throws DataFormatException {
    if (!node.isNumber() || !valid.test(node.doubleValue())) {
      throw isNot(expected);
    }
    return node.doubleValue();
  }

  double finite(String field) throws DataFormatException {
    return number(field, value -> Math.abs(value) <= GREATEST, "a finite number" + UP_TO);
  }

  double notNegative(String field) throws DataFormatException {
    return number(
        field, value -> value >= 0 && value <= GREATEST, "a number of at least 0" + UP_TO);
  }

  double positive(String field) throws DataFormatException {
    return number(field, value -> value > 0 && value <= GREATEST, "a number above 0" + UP_TO);
  }

  /** Returns a whole number of 64 bits, to the last digit. */
  public long whole() throws DataFormatException {
    if (!node.isIntegralNumber() || !node.canConvertToLong()) {
      throw isNot("a whole number of 64 bits");
    }
    return node.longValue();
  }

  /** Returns a truth value. */
  public boolean truth() throws DataFormatException {
    if (!node.isBoolean()) {
      throw isNot("true or false");
    }
    return node.booleanValue();
  }

  /** Makes the exception for a value that is not what was expected. */
  public DataFormatException isNot(String expected) {
    return fault(node + " is not " + expected);
  }

  /** Makes the exception for a value that is wrong in another way. */
  public DataFormatException fault(String problem) {
    return DataFormatException.inField(file, line(pointer), name(pointer), problem);
  }

  private DataFormatException fault(String field, String problem) {
    return DataFormatException.inField(file, line(pointer), name(below(field)), problem);
  }

  /** A field's pointer (RFC 6901), which has other signs for the two that it needs itself. */
  private String below(String field) {
    return pointer + "/" + field.replace("~", "~0").replace("/", "~1");
  }

  private int line(String at) {
    return lines.getOrDefault(at, 1);
  }

  /** As one would write it in code: sensor.name, obstacles.0.outline_m. */
  private static String name(String at) {
    return at.isEmpty()
        ? "JSON"
        : at.substring(1).replace('/', '.').replace("~1", "/").replace("~0", "~");
  }
}
