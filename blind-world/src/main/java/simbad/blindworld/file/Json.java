package simbad.blindworld.file;

import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * JSON as maps, lists, strings, doubles and booleans. Written with one space of indent a level,
 * numbers to at most nine decimals, keys in the order of the map: equal values give equal bytes.
 */
public final class Json {

  private Json() {}

  /** The text of a value, with a line's end at its end. */
  public static String write(Object value) {
    StringBuilder text = new StringBuilder();
    append(text, value, 0);
    return text.append('\n').toString();
  }

  private static void append(StringBuilder text, Object value, int depth) {
    if (value instanceof Map<?, ?> map) {
      appendAll(text, map.entrySet().iterator(), depth, "{}");
    } else if (value instanceof List<?> list) {
      appendAll(text, list.iterator(), depth, "[]");
    } else if (value instanceof Map.Entry<?, ?> entry) {
      appendString(text, String.valueOf(entry.getKey()));
      append(text.append(": "), entry.getValue(), depth);
    } else if (value instanceof Number number) {
      text.append(number(number));
    } else if (value instanceof Boolean) {
      text.append(value);
    } else {
      appendString(text, String.valueOf(value));
    }
  }

  private static void appendAll(StringBuilder text, Iterator<?> values, int depth, String ends) {
    text.append(ends.charAt(0));
    boolean empty = !values.hasNext();
    while (values.hasNext()) {
      text.append('\n').append(" ".repeat(depth + 1));
      append(text, values.next(), depth + 1);
      if (values.hasNext()) {
        text.append(',');
      }
    }
    if (!empty) {
      text.append('\n').append(" ".repeat(depth));
    }
    text.append(ends.charAt(1));
  }

  /** A number without needless digits; infinite and undefined ones have no JSON and are refused. */
  static String number(Number number) {
    if (number instanceof Integer || number instanceof Long) {
      return number.toString();
    }
    double value = number.doubleValue();
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("number: " + value + ", expected a finite one");
    }
    String digits = String.format(Locale.ROOT, "%.9f", value);
    String cut = digits.replaceFirst("0+$", "");
    String whole = cut.endsWith(".") ? cut + "0" : cut;
    return whole.equals("-0.0") ? "0.0" : whole;
  }

  private static void appendString(StringBuilder text, String string) {
    text.append('"');
    for (int i = 0; i < string.length(); i++) {
      char c = string.charAt(i);
      if (c == '"' || c == '\\') {
        text.append('\\').append(c);
      } else if (c < ' ') {
        text.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      } else {
        text.append(c);
      }
    }
    text.append('"');
  }
}
