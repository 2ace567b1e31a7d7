package simbad.figures.blindcheck;

import java.io.IOException;
import java.nio.file.Path;
import simbad.experiments.blindcheck.CheckFiles;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckScores;
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
    CheckFiles.write(folder, order, scores);
    TextFile.write(folder.resolve(PAGE), CheckPage.of(order, scores));
  }
}
