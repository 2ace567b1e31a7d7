package simbad.cli;

import java.io.IOException;
import java.util.ServiceLoader;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.cli.machine.Launcher;
import simbad.experiments.workers.Cluster;
import simbad.experiments.workers.LocalWorkers;
import simbad.experiments.workers.Workers;

/** Who does the pieces of a job, as the user says it. */
final class WorkersOption {
  /** Spark's other kinds of clusters as well, which nobody has tried. */
  private static final Pattern MASTER =
      Pattern.compile("spark://.+:\\d+.*|local(-cluster)?(\\[.+])?|yarn|k8s://.+");

  @Option(
      names = "--jobs",
      paramLabel = "N",
      description =
          "How many cases or runs this machine works on at a time. Default: one for each "
              + "core.")
  private int jobs = Runtime.getRuntime().availableProcessors();

  @Option(
      names = "--spark",
      paramLabel = "MASTER",
      description = "Let Apache Spark do the work: spark://HOST:PORT or local[N].")
  private @Nullable String master;

  /**
   * Refuses what cannot be, before any work is done. Where Spark is asked for and is not among this
   * program's jars, a process that has it does the whole command.
   *
   * @return whether such a process did it
   */
  boolean isDoneElsewhere(Subcommand command) throws IOException, InterruptedException {
    if (jobs < 1) {
      throw command.wrongUsage("--jobs: " + jobs + " is not at least 1");
    }
    if (master != null && !MASTER.matcher(master).matches()) {
      throw command.wrongUsage("--spark: '" + master + "' is not spark://HOST:PORT or local[N]");
    }
    if (master == null || cluster() != null) {
      return false;
    }
    Launcher launcher =
        Launcher.ofThisProcess()
            .orElseThrow(
                () ->
                    command.wrongUsage(
                        "--spark: Spark is not among this program's jars; ./simbad adds it"));
    command.endAs(SparkProcess.run(launcher, command.words(), command.err()));
    return true;
  }

  /**
   * Reaches them.
   *
   * @throws IOException when there are none
   */
  Workers open() throws IOException {
    Cluster cluster = cluster();
    return master == null || cluster == null ? new LocalWorkers(jobs) : cluster.connect(master);
  }

  private static @Nullable Cluster cluster() {
    return ServiceLoader.load(Cluster.class).findFirst().orElse(null);
  }
}
