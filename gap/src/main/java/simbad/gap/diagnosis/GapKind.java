package simbad.gap.diagnosis;

/** In what way simulation and reality part at a place. */
public enum GapKind {
  /** The simulator expects echoes that are not read. */
  MISSED_ECHO("missed echo"),
  /** Echoes are read that the simulator does not expect. */
  PHANTOM_ECHO("phantom echo"),
  /** Echoes are read at other ranges than the simulator expects. */
  RANGE_ERROR("range error");

  private final String words;

  GapKind(String words) {
    this.words = words;
  }

  /** Returns the words as they stand in files. */
  public String words() {
    return words;
  }
}
