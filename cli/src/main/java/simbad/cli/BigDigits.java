package simbad.cli;

import java.util.ArrayList;
import java.util.List;

/** Numbers and LOST that can be read from two metres away: each figure five lines high. */
final class BigDigits {
  private static final int ROWS = 5;
  private static final String KNOWN = "0123456789.-\u00b0LOST";

  /** A row of three marks for each figure of KNOWN, from above. */
  private static final List<String> MARKS =
      List.of(
          "### .#. ### ### #.# ### ### ### ### ### ... ... ### #.. ### ### ###",
          "#.# ##. ..# ..# #.# #.. #.. ..# #.# #.# ... ... #.# #.. #.# #.. .#.",
          "#.# .#. ### ### ### ### ### ..# ### ### ... ### ### #.. #.# ### .#.",
          "#.# .#. #.. ..# ..# ..# #.# ..# #.# ..# ... ... ... #.. #.# ..# .#.",
          "### ### ### ### ..# ### ### ..# ### ### .#. ... ... ### ### ### .#.");

  private BigDigits() {}

  /** The lines of a number; what has no figure is a gap. */
  static List<String> of(String number) {
    List<String> lines = new ArrayList<>();
    for (int row = 0; row < ROWS; row++) {
      StringBuilder line = new StringBuilder();
      String[] marks = MARKS.get(row).split(" ", -1);
      for (int i = 0; i < number.length(); i++) {
        int figure = KNOWN.indexOf(number.charAt(i));
        String shape = figure < 0 ? "..." : marks[figure];
        line.append(shape.replace("#", "██").replace(".", "  ")).append("  ");
      }
      lines.add(line.toString().stripTrailing());
    }
    return lines;
  }
}
