package simbad.blindworld.file;

/** Numbers with a fixed count of decimals, the same way for every column and case. */
public final class Decimals {

  private Decimals() {}

  /** Appends a number rounded to so many decimals, all of them written. */
  public static StringBuilder append(StringBuilder text, double value, int decimals) {
    long scale = Math.round(StrictMath.pow(10, decimals));
    long units = Math.round(value * scale);
    String digits = Long.toString(scale + Math.abs(units % scale)).substring(1);
    return text.append(units < 0 ? "-" : "")
        .append(Math.abs(units / scale))
        .append('.')
        .append(digits);
  }
}
