package simbad.blindworld;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.FormatException;

/** {@code --name value} pairs of a command line. */
final class Options {

  private final Map<String, String> values = new HashMap<>();

  Options(String[] arguments, List<String> known) throws FormatException {
    for (int i = 0; i < arguments.length; i += 2) {
      String name = arguments[i];
      if (!known.contains(name)) {
        throw new FormatException("'" + name + "': expected one of " + String.join(" ", known));
      }
      if (i + 1 == arguments.length) {
        throw new FormatException(name + ": expected a value after it");
      }
      values.put(name, arguments[i + 1]);
    }
  }

  Optional<String> text(String name) {
    return Optional.ofNullable(values.get(name));
  }

  String required(String name) throws FormatException {
    return text(name).orElseThrow(() -> new FormatException(name + ": missing"));
  }

  double number(String name, double absent, double least, double most) throws FormatException {
    String value = values.get(name);
    return value == null ? absent : inside(name, value, least, most);
  }

  static double inside(String name, String value, double least, double most)
      throws FormatException {
    try {
      double number = Double.parseDouble(value);
      if (number >= least && number <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Said below, as for a number that is out of bounds.
    }
    throw new FormatException(
        name + ": '" + value + "', expected a number in [" + least + ", " + most + "]");
  }

  long whole(String name, long absent) throws FormatException {
    String value = values.get(name);
    try {
      return value == null ? absent : Long.parseLong(value);
    } catch (NumberFormatException e) {
      throw new FormatException(name + ": '" + value + "', expected a whole number");
    }
  }
}
