package simbad.figures.blindcheck;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simbad.experiments.blindcheck.CheckFiles;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.ToldApart;
import simbad.sonar.format.TextFile;

/** A check's results with their page. */
public final class CheckReport {
  /** The name of the page. */
  public static final String PAGE = "report.html";

  private CheckReport() {}

  /**
   * Writes everything, over what an earlier scoring left.
   *
   * @param folder exists
   * @param order what was asked for
   * @param scores of it
   * @throws IOException if something cannot be written
   */
  public static void write(Path folder, CheckOrder order, CheckScores scores) throws IOException {
    write(folder, order, scores, List.of());
  }

  /**
   * Writes everything, over what an earlier scoring left.
   *
   * @param folder exists
   * @param order what was asked for
   * @param scores of it
   * @param next what came of what the answers proposed to measure next; empty if that was not asked
   * @throws IOException if something cannot be written
   */
  public static void write(Path folder, CheckOrder order, CheckScores scores, List<ToldApart> next)
      throws IOException {
    CheckFiles.write(folder, order, scores);
    TextFile.write(folder.resolve(PAGE), CheckPage.of(order, scores, next));
  }
}
