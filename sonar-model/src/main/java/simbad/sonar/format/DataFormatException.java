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
    return new DataFormatException(
        OneLine.of(file.toString()) + ": " + OneLine.of(problem, LONGEST_PROBLEM));
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
        OneLine.of(file.toString()) + ":" + line + ": " + OneLine.of(field, LONGEST_FIELD);
    return new DataFormatException(where + ": " + OneLine.of(problem, LONGEST_PROBLEM));
  }

  /**
   * A wrong name or value that stands in no file, such as one on a command line.
   *
   * @param what the argument
   * @param problem what is wrong and what was expected
   */
  public static DataFormatException inArgument(String what, String problem) {
    return new DataFormatException(
        OneLine.of(what, LONGEST_FIELD) + ": " + OneLine.of(problem, LONGEST_PROBLEM));
  }
}
