package simbad.cli;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.batch.BatchFolder;
import simbad.experiments.batch.BatchJob;
import simbad.experiments.batch.ResultLog;
import simbad.experiments.workers.Workers;
import simbad.figures.batch.BatchReport;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** {@code simbad batch}: many runs. */
@Command(
    name = "batch",
    description = {
      "Let robots circle obstacles, many runs in one call.",
      "A spec lists obstacles, scenes, sensors, effects, controllers, speeds and "
          + "seeds. Every combination is run, or a sample of them (docs/guide/batch.md).",
      "Each run becomes a row of results.csv in --out. The same command continues a "
          + "batch that was interrupted.",
      "At the end report.html shows the errors, and the runs that went wrong."
    },
    footer = {
      "",
      "Example: simbad batch data/batch/edge-follower-tuning.json --out tuning",
      "Example: simbad batch my-spec.json --out results --spark spark://host:7077"
    })
final class BatchCommand extends Subcommand {
  @Parameters(
      paramLabel = "SPEC",
      description = "A JSON file. Paths in it are relative to its folder.")
  @SuppressWarnings("NullAway.Init")
  private Path spec;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "A folder that does not exist yet, or the folder of this batch.")
  @SuppressWarnings("NullAway.Init")
  private Path out;

  @ArgGroup private WorkersOption who = new WorkersOption();

  @Override
  protected void run() throws Exception {
    if (who.isDoneElsewhere(this)) {
      return;
    }
    try {
      drive(job(TextFile.read(spec)));
    } catch (AccessDeniedException e) {
      // The spec is as it should be; it is the work that cannot be done here.
      throw new IOException(e.getFile() + ": permission denied", e);
    }
  }

  private void drive(BatchJob job) throws IOException, DataFormatException, InterruptedException {
    try (ResultLog log = ResultLog.open(out, job)) {
      long before = log.done();
      if (before > 0) {
        out().println(before + " of " + runsAre(job.size()) + " there already");
        out().flush();
      }
      work(job, log);
      BatchReport.write(out, BuildVersion.text());
      out().println(runs(log.done()) + " in " + out.resolve("results.csv"));
      out().println("report: " + out.resolve(BatchReport.PAGE));
      if (log.failed() > 0) {
        complain(new IOException(failures(log)));
      }
    }
  }

  private static String failures(ResultLog log) {
    return log.failed() + " of " + runs(log.done()) + " failed; their rows say why";
  }

  /** The batch of the folder, which is begun if it is not yet. */
  private BatchJob job(String text) throws IOException, DataFormatException {
    String version = BuildVersion.text();
    if (BatchFolder.isBegun(out)) {
      return BatchFolder.read(out, spec, text, version);
    }
    BatchJob job = BatchJob.read(spec, text);
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      BatchFolder.write(staged.path(), job, version);
      staged.publish();
      return job;
    }
  }

  private void work(BatchJob job, ResultLog log) throws IOException, InterruptedException {
    if (log.done() == job.size()) {
      return;
    }
    Ending ending = Ending.with(() -> err().println(standing(job, log)));
    try (Workers workers = who.open();
        Progress progress = Progress.of("driving", job.size() - log.done())) {
      workers.run(
          job,
          log.done(),
          job.size(),
          outcome -> {
            log.append(outcome);
            progress.step();
          });
    } finally {
      ending.close();
    }
  }

  private static String runs(long count) {
    return count + (count == 1 ? " run" : " runs");
  }

  private static String runsAre(long count) {
    return runs(count) + (count == 1 ? " is" : " are");
  }

  private String standing(BatchJob job, ResultLog log) {
    return "simbad batch: "
        + log.done()
        + " of "
        + runsAre(job.size())
        + " in "
        + out
        + "; the same command continues";
  }
}
