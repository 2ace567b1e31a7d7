package simbad.experiments.blindcheck;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;

/**
 * What came of one answer's proposal to measure next: it was measured in the sealed world and
 * diagnosed again.
 *
 * @param caseId of the check
 * @param so what is at work
 * @param separates what the proposal was to tell apart
 * @param outcome right, tied or wrong
 * @param saidBefore the answer that proposed it
 * @param saidAfter the answer with what was measured
 */
public record ToldApart(
    String caseId,
    String so,
    String separates,
    String outcome,
    String saidBefore,
    String saidAfter) {
  private static final List<String> OUTCOMES = List.of("right", "tied", "wrong");

  /**
   * Reads the scorer's table of proposals.
   *
   * @param csv with a row for each
   * @throws DataFormatException if it is another table
   */
  public static List<ToldApart> read(Path csv) throws IOException, DataFormatException {
    CsvTable table = CsvTable.parse(csv, Files.readString(csv));
    table.requireColumns("case", "so", "separates", "outcome", "said_before", "said_after");
    List<ToldApart> all = new ArrayList<>();
    for (int row = 0; row < table.size(); row++) {
      String outcome = table.text(row, "outcome");
      if (!OUTCOMES.contains(outcome)) {
        throw DataFormatException.inField(
            csv, table.line(row), "outcome", outcome + ", expected one of " + OUTCOMES);
      }
      all.add(
          new ToldApart(
              table.text(row, "case"),
              table.text(row, "so"),
              table.text(row, "separates"),
              outcome,
              table.text(row, "said_before"),
              table.text(row, "said_after")));
    }
    return all;
  }

  /**
   * Counts an outcome.
   *
   * @param all one or more
   * @param outcome right, tied or wrong
   */
  public static WilsonShare share(List<ToldApart> all, String outcome) {
    long hits = all.stream().filter(one -> one.outcome.equals(outcome)).count();
    return new WilsonShare((int) hits, all.size());
  }
}
