package simbad.experiments.batch;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoublePredicate;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/**
 * What the fields of a spec have in common: none is unknown, no list is empty or repeats itself.
 */
final class SpecFields {
  private SpecFields() {}

  /** A misspelt field must not pass for one that was left out. */
  static void allowOnly(JsonInput object, String... known) throws DataFormatException {
    for (String name : object.names()) {
      if (!List.of(known).contains(name)) {
        throw object
            .field(name)
            .fault("is not a field here, expected one of " + String.join(", ", known));
      }
    }
  }

  /** The items of a list that is not empty; none where the field is missing. */
  static List<JsonInput> items(JsonInput object, String field) throws DataFormatException {
    return object.has(field) ? filled(object.field(field)) : List.of();
  }

  private static List<JsonInput> filled(JsonInput list) throws DataFormatException {
    List<JsonInput> items = list.items();
    if (items.isEmpty()) {
      throw list.fault("is empty, expected at least one");
    }
    return items;
  }

  /** One number, or a list of different ones. */
  static List<Double> numbers(JsonInput value, DoublePredicate valid, String expected)
      throws DataFormatException {
    List<Double> numbers = new ArrayList<>();
    for (JsonInput item : value.isList() ? filled(value) : List.of(value)) {
      double number = item.number(valid, expected);
      if (numbers.contains(number)) {
        throw item.fault(number + " appears twice");
      }
      numbers.add(number);
    }
    return numbers;
  }

  /** A list of different whole numbers. */
  static List<Long> wholes(JsonInput list) throws DataFormatException {
    List<Long> numbers = new ArrayList<>();
    Set<Long> before = new HashSet<>();
    for (JsonInput item : filled(list)) {
      if (!before.add(item.whole())) {
        throw item.fault(item.whole() + " appears twice");
      }
      numbers.add(item.whole());
    }
    return numbers;
  }

  /** A whole number of at least 1. */
  static long count(JsonInput value) throws DataFormatException {
    if (value.whole() < 1) {
      throw value.isNot("a whole number of at least 1");
    }
    return value.whole();
  }
}
