package simbad.sonar.format;

/** The formats of data sets. */
public enum DataFormat {
  /** Every row has a time; columns that are not needed are ignored. */
  FIRST("sonar-gap/1"),
  /** Rows may have no time and may say more of themselves, scenes say more as well. */
  SECOND("sonar-gap/2");

  private final String word;

  DataFormat(String word) {
    this.word = word;
  }

  /** Returns the name in files. */
  public String word() {
    return word;
  }
}
