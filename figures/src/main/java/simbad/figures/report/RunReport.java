package simbad.figures.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.report.RunFiles;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.RunResult;

/** A run's folder with its pictures and its page. */
public final class RunReport {
  private RunReport() {}

  /**
   * Writes everything.
   *
   * @param folder exists and is empty
   * @param origin what made the results
   * @param results obstacle by obstacle
   * @throws IOException if something cannot be written
   */
  public static void write(Path folder, RunOrigin origin, List<RunResult> results)
      throws IOException {
    write(folder, origin, results, PageTop.RUN);
  }

  /**
   * Writes everything, with the verdict of the fidelity test at the top of the page.
   *
   * @param folder exists and is empty
   * @param origin what made the results
   * @param results obstacle by obstacle
   * @param limits by which they are judged
   * @throws IOException if something cannot be written
   */
  public static void write(
      Path folder, RunOrigin origin, List<RunResult> results, FidelityLimits limits)
      throws IOException {
    write(folder, origin, results, PageTop.verdict(results, limits));
  }

  private static void write(Path folder, RunOrigin origin, List<RunResult> results, PageTop top)
      throws IOException {
    Map<String, String> hashes = RunFiles.write(folder, origin, results);
    Map<String, List<RunResult>> byObstacle = RunFiles.byObstacle(results);
    for (Map.Entry<String, List<RunResult>> entry : byObstacle.entrySet()) {
      RunPictures.write(folder.resolve(entry.getKey()), entry.getValue());
    }
    ReportPage.write(folder.resolve("report.html"), top, origin, hashes, byObstacle);
  }
}
