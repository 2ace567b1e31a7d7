package simbad.figures.batch;

import java.io.IOException;
import java.nio.file.Path;
import simbad.experiments.batch.BatchSurvey;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** The page of a batch: what its rows say at a glance, and the runs that went wrong. */
public final class BatchReport {
  /** The page's name in the folder. */
  public static final String PAGE = "report.html";

  private BatchReport() {}

  /**
   * Writes the page, over one that is there.
   *
   * @param folder of a batch whose runs are done
   * @param version of the program
   * @throws DataFormatException if the rows are not those of a batch
   * @throws IOException if something cannot be read or written
   */
  public static void write(Path folder, String version) throws IOException, DataFormatException {
    TextFile.write(folder.resolve(PAGE), BatchPage.of(BatchSurvey.read(folder), version));
  }
}
