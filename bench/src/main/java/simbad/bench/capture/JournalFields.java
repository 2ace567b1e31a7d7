package simbad.bench.capture;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;

/**
 * The fields of one line, read with their ranges: who can sum up a line anew can write anything
 * into it.
 *
 * @param fields in their order
 */
record JournalFields(List<String> fields) {
  private static final Pattern WHOLE = Pattern.compile("\\d{1,9}");

  String text(int index, String name) throws JournalFieldException {
    if (index >= fields.size()) {
      throw new JournalFieldException(name, "is missing");
    }
    return fields.get(index);
  }

  /** Empty, not missing. */
  boolean isEmpty(int index) {
    return index < fields.size() && fields.get(index).isEmpty();
  }

  double number(int index, String name, double least, double greatest)
      throws JournalFieldException {
    String text = text(index, name);
    double value = parsed(text);
    if (!(value >= least && value <= greatest)) {
      String from = least == Double.MIN_VALUE ? "(0" : "[" + least;
      throw notWithin(name, text, "a number in " + from + ", " + greatest + "]");
    }
    return value;
  }

  private static double parsed(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  int whole(int index, String name, int least, int greatest) throws JournalFieldException {
    String text = text(index, name);
    String expected = "a whole number in [" + least + ", " + greatest + "]";
    if (!WHOLE.matcher(text).matches()) {
      throw notWithin(name, text, expected);
    }
    int value = Integer.parseInt(text);
    if (value < least || value > greatest) {
      throw notWithin(name, text, expected);
    }
    return value;
  }

  <T> T word(int index, String name, Function<String, Optional<T>> find)
      throws JournalFieldException {
    String text = text(index, name);
    return find.apply(text)
        .orElseThrow(() -> new JournalFieldException(name, "'" + text + "' is none"));
  }

  private static JournalFieldException notWithin(String name, String text, String expected) {
    return new JournalFieldException(name, "'" + text + "' is not " + expected);
  }
}
