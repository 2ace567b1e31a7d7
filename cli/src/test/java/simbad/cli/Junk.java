package simbad.cli;

import java.util.List;
import java.util.stream.Stream;

/** What tests put into a file at some place, where something else belongs. */
final class Junk {
  private static final List<String> OF_ANY_FILE =
      List.of(
          "",
          ",",
          ",,",
          "\n",
          "\"",
          "NaN",
          "1e300",
          "-1",
          "0",
          "Infinity",
          "1,5",
          "x",
          "\u0000",
          "#",
          ";",
          "-0.0",
          "1e-320",
          "9".repeat(400),
          "n".repeat(70_000),
          "\u001b[2J",
          "\uFEFF",
          "\t");

  private Junk() {}

  /** Returns what is wrong in any file, and more of one kind of file. */
  static List<String> and(String... more) {
    return Stream.concat(OF_ANY_FILE.stream(), Stream.of(more)).toList();
  }
}
