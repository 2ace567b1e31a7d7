package simbad.bench.capture;

/** A field of a journal's line that no capture can have written, though the checksum fits. */
final class JournalFieldException extends Exception {
  private static final long serialVersionUID = 1;

  private final String field;

  /**
   * Says what is wrong.
   *
   * @param field of the line
   * @param problem what stands there and what was expected
   */
  JournalFieldException(String field, String problem) {
    super(problem);
    this.field = field;
  }

  String field() {
    return field;
  }

  String problem() {
    return String.valueOf(getMessage());
  }
}
