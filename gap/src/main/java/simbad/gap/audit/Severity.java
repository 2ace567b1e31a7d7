package simbad.gap.audit;

/** What a finding means for the diagnosis. */
public enum Severity {
  /** Worth knowing; nothing is wrong with the data for all that is known. */
  NOTE("note"),
  /** Something is wrong with the data; the fit may account for it. */
  WARN("warn"),
  /** No reading can be believed as the data stand: nothing is fitted. */
  REFUSE("refuse");

  private final String word;

  Severity(String word) {
    this.word = word;
  }

  /** Returns the word as it stands in files. */
  public String word() {
    return word;
  }
}
