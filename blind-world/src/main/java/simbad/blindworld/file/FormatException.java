package simbad.blindworld.file;

/**
 * Input that does not keep to its format; the message names file, line or field, and what was
 * expected.
 */
public final class FormatException extends Exception {

  private static final long serialVersionUID = 1L;

  /** Says what is wrong where. */
  public FormatException(String message) {
    super(message);
  }
}
