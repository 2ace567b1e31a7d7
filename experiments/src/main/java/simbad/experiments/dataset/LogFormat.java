package simbad.experiments.dataset;

import java.nio.charset.Charset;
import java.util.Optional;

/**
 * How a log is written; what is empty is found out.
 *
 * @param encoding of its characters
 * @param separator of its fields; a blank stands for any number of blanks and tabs
 * @param decimalComma whether numbers have a comma
 * @param header whether the first line names the columns
 * @param skip so many lines at the begin are none of the table
 * @param comment lines that begin so are none either; #, % and // in any case
 * @param skipBad whether lines that cannot be read are left out, not refused
 */
record LogFormat(
    Optional<Charset> encoding,
    Optional<Character> separator,
    Optional<Boolean> decimalComma,
    Optional<Boolean> header,
    int skip,
    Optional<String> comment,
    boolean skipBad) {
  /** A csv file as programs write it: commas, points, a header. */
  static final LogFormat PLAIN =
      new LogFormat(
          Optional.empty(),
          Optional.of(','),
          Optional.of(false),
          Optional.of(true),
          0,
          Optional.empty(),
          false);
}
