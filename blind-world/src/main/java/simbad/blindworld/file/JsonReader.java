package simbad.blindworld.file;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the JSON of RFC 8259 into maps, lists, strings, doubles, booleans and {@link #NULL}. */
public final class JsonReader {

  /** What stands for JSON's null. */
  public static final Optional<Object> NULL = Optional.empty();

  private static final int DEEPEST = 200;

  private final String file;
  private final String text;
  private int at;
  private int depth;

  private JsonReader(String file, String text) {
    this.file = file;
    this.text = text;
  }

  /** The value of a text; {@code file} names it in complaints. */
  public static Object read(String file, String text) throws FormatException {
    JsonReader reader = new JsonReader(file, text);
    Object value = reader.value();
    reader.blanks();
    if (reader.at < text.length()) {
      throw reader.wrong("the end");
    }
    return value;
  }

  private FormatException wrong(String expected) {
    long line = 1 + text.chars().limit(at).filter(c -> c == '\n').count();
    String found = at < text.length() ? "'" + text.charAt(at) + "'" : "the end of the file";
    return new FormatException(
        file + ", line " + line + ": found " + found + ", expected " + expected);
  }

  private void blanks() {
    while (at < text.length() && " \t\r\n".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
  }

  private char peek() {
    blanks();
    return at < text.length() ? text.charAt(at) : '\0';
  }

  private void expect(char c) throws FormatException {
    if (peek() != c) {
      throw wrong("'" + c + "'");
    }
    at++;
  }

  private Object value() throws FormatException {
    if (++depth > DEEPEST) {
      throw wrong("at most " + DEEPEST + " levels");
    }
    char c = peek();
    Object value;
    if (c == '{') {
      value = object();
    } else if (c == '[') {
      value = array();
    } else if (c == '"') {
      value = string();
    } else if (c == '-' || (c >= '0' && c <= '9')) {
      value = number();
    } else {
      value = word();
    }
    depth--;
    return value;
  }

  private Map<String, Object> object() throws FormatException {
    Map<String, Object> map = new LinkedHashMap<>();
    expect('{');
    while (peek() != '}') {
      String key = string();
      expect(':');
      map.put(key, value());
      if (peek() != '}') {
        expect(',');
      }
    }
    at++;
    return map;
  }

  private List<Object> array() throws FormatException {
    List<Object> list = new ArrayList<>();
    expect('[');
    while (peek() != ']') {
      list.add(value());
      if (peek() != ']') {
        expect(',');
      }
    }
    at++;
    return list;
  }

  private String string() throws FormatException {
    expect('"');
    StringBuilder string = new StringBuilder();
    while (at < text.length() && text.charAt(at) != '"') {
      char c = text.charAt(at++);
      string.append(c == '\\' ? escaped() : c);
    }
    expect('"');
    return string.toString();
  }

  private char escaped() throws FormatException {
    if (at >= text.length()) {
      throw wrong("an escape");
    }
    char c = text.charAt(at++);
    if (c == 'u') {
      return unicode();
    }
    int known = "\"\\/bfnrt".indexOf(c);
    if (known < 0) {
      throw wrong("an escape");
    }
    return "\"\\/\b\f\n\r\t".charAt(known);
  }

  private char unicode() throws FormatException {
    try {
      char c = (char) Integer.parseInt(text.substring(at, at + 4), 16);
      at += 4;
      return c;
    } catch (IndexOutOfBoundsException | NumberFormatException e) {
      throw wrong("four hexadecimal digits");
    }
  }

  private Double number() throws FormatException {
    int begin = at;
    while (at < text.length() && "+-.eE0123456789".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
    try {
      return Double.valueOf(text.substring(begin, at));
    } catch (NumberFormatException e) {
      at = begin;
      throw wrong("a number");
    }
  }

  private Object word() throws FormatException {
    for (Map.Entry<String, Object> word :
        Map.<String, Object>of("true", true, "false", false, "null", NULL).entrySet()) {
      if (text.startsWith(word.getKey(), at)) {
        at += word.getKey().length();
        return word.getValue();
      }
    }
    throw wrong("a value");
  }
}
