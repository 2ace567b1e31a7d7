package simbad.blindworld.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An object of a JSON file whose fields are asked for by name and kind.
 *
 * @param where the file, and the path of fields to this object
 * @param fields by name, in the order of the file
 */
public record JsonObject(String where, Map<String, Object> fields) {

  /** The object that a file holds. */
  public static JsonObject read(Path path) throws IOException, FormatException {
    return parse(path.toString(), Files.readString(path));
  }

  /** The object that a text holds; {@code file} names it in complaints. */
  public static JsonObject parse(String file, String text) throws FormatException {
    return of(file, JsonReader.read(file, text));
  }

  private static JsonObject of(String where, Object value) throws FormatException {
    if (!(value instanceof Map<?, ?> map)) {
      throw new FormatException(where + ": expected an object");
    }
    Map<String, Object> fields = new LinkedHashMap<>();
    map.forEach((key, field) -> fields.put(String.valueOf(key), field));
    return new JsonObject(where, fields);
  }

  private <T> T field(String name, Class<T> kind, String expected) throws FormatException {
    Object value = fields.get(name);
    if (!kind.isInstance(value)) {
      throw new FormatException(where + ", " + name + ": expected " + expected);
    }
    return kind.cast(value);
  }

  /** True when there is a field of the name that is not null. */
  public boolean has(String name) {
    return fields.getOrDefault(name, JsonReader.NULL) != JsonReader.NULL;
  }

  /** A field's number, which must be finite. */
  public double number(String name) throws FormatException {
    double value = field(name, Double.class, "a number");
    if (!Double.isFinite(value)) {
      throw new FormatException(where + ", " + name + ": expected a finite number");
    }
    return value;
  }

  /** A field's number, when there is the field. */
  public Optional<Double> optionalNumber(String name) throws FormatException {
    return has(name) ? Optional.of(number(name)) : Optional.empty();
  }

  /** A field's number, which must be in an interval with its ends. */
  public double within(String name, double least, double most) throws FormatException {
    double value = number(name);
    if (!(value >= least && value <= most)) {
      throw new FormatException(
          "%s, %s: %s, expected a number in [%s, %s]".formatted(where, name, value, least, most));
    }
    return value;
  }

  /** A field's text. */
  public String text(String name) throws FormatException {
    return field(name, String.class, "a text");
  }

  /** A field's object. */
  public JsonObject object(String name) throws FormatException {
    return of(where + ", " + name, field(name, Map.class, "an object"));
  }

  /** A field's list of objects. */
  public List<JsonObject> objects(String name) throws FormatException {
    List<JsonObject> objects = new ArrayList<>();
    for (Object each : field(name, List.class, "a list of objects")) {
      objects.add(of(where + ", " + name + "[" + objects.size() + "]", each));
    }
    return objects;
  }

  /** A field's list of texts. */
  public List<String> texts(String name) throws FormatException {
    return listOf(name, String.class, "a list of texts");
  }

  /** True when a field is a list with a null in it. */
  public boolean hasNull(String name) throws FormatException {
    return field(name, List.class, "a list").contains(JsonReader.NULL);
  }

  /** A field's list of numbers. */
  public List<Double> numbers(String name) throws FormatException {
    return listOf(name, Double.class, "a list of numbers");
  }

  /** A field's list of lists of numbers. */
  public List<List<Double>> numberLists(String name) throws FormatException {
    List<List<Double>> lists = new ArrayList<>();
    for (Object each : field(name, List.class, "a list of lists")) {
      lists.add(new JsonObject(where, Map.of(name, each)).numbers(name));
    }
    return lists;
  }

  /** A field's list of lists of texts. */
  public List<List<String>> textLists(String name) throws FormatException {
    List<List<String>> lists = new ArrayList<>();
    for (Object each : field(name, List.class, "a list of lists")) {
      lists.add(new JsonObject(where, Map.of(name, each)).texts(name));
    }
    return lists;
  }

  private <T> List<T> listOf(String name, Class<T> kind, String expected) throws FormatException {
    List<T> values = new ArrayList<>();
    for (Object each : field(name, List.class, expected)) {
      if (!kind.isInstance(each)) {
        throw new FormatException(where + ", " + name + ": expected " + expected);
      }
      values.add(kind.cast(each));
    }
    return values;
  }
}
