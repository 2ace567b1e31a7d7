package simbad.sonar.format;

import java.nio.file.Path;

/**
 * Bad input: says in one line which file, which line, which field, what is there, what should be.
 */
public final class DataFormatException extends Exception {
  private static final long serialVersionUID = 1;
  private static final int LONGEST_FIELD = 80;
  private static final int LONGEST_PROBLEM = 320;

  private DataFormatException(String message) {
    super(message);
  }

  /**
   * A fault of a whole file.
   *
   * @param file as the user named it
   * @param problem what is wrong and what was expected
   */
  public static DataFormatException inFile(Path file, String problem) {
    return new DataFormatException(oneLine(file.toString()) + ": " + shown(problem));
  }

  /**
   * A fault of one field.
   *
   * @param file as the user named it
   * @param line from 1
   * @param field column or path of the value
   * @param problem what is wrong and what was expected
   */
  public static DataFormatException inField(Path file, long line, String field, String problem) {
    String where =
        oneLine(file.toString()) + ":" + line + ": " + oneLine(cut(field, LONGEST_FIELD));
    return new DataFormatException(where + ": " + shown(problem));
  }

  /**
   * A wrong name or value that stands in no file, such as one on a command line.
   *
   * @param what the argument
   * @param problem what is wrong and what was expected
   */
  public static DataFormatException inArgument(String what, String problem) {
    return new DataFormatException(oneLine(cut(what, LONGEST_FIELD)) + ": " + shown(problem));
  }

  private static String shown(String problem) {
    return oneLine(cut(problem, LONGEST_PROBLEM));
  }

  /** The begin tells what is there, the end what is wrong with it. */
  private static String cut(String text, int longest) {
    int half = longest / 2;
    return text.length() <= longest
        ? text
        : text.substring(0, half) + "..." + text.substring(text.length() - half);
  }

  /** What is quoted from a bad file may hold line breaks and a terminal's control characters. */
  private static String oneLine(String text) {
    return text.replaceAll("\\s*[\\p{Cc}\\u2028\\u2029]+\\s*", " ");
  }
}
