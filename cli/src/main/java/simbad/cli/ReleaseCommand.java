package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.cli.machine.Launcher;

/** {@code simbad release}. */
@Command(
    name = "release",
    description = {
      "Make a release of the current commit: one jar with everything, the sources, "
          + "the Javadoc, an SBOM, the licences of all parts, the changelog and checksums.",
      "The same commit gives the same bytes. Changes that are not committed are left out."
    },
    footer = {
      "",
      "Example: simbad release --out simbad-sonar-0.1.0",
      "Example: simbad release --jar-only --out my-jar",
      "Example: simbad release --publish --out repository",
      "How to publish one: docs/guide/release.md",
    })
final class ReleaseCommand extends Subcommand {
  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "A folder that does not exist yet.")
  private Path out = Path.of("");

  @Option(
      names = "--jar-only",
      description = "Make only simbad.jar, quickly: for programs that use it.")
  private boolean jarOnly;

  @Option(
      names = "--publish",
      description =
          "Make the folder that a Maven repository takes instead. Needs gpg, and what "
              + Publication.FILE
              + " asks for.")
  private boolean publish;

  @Option(
      names = "--unsigned",
      description = "With --publish: without signatures, for a look at it.")
  private boolean unsigned;

  @Option(
      names = "--stale-figures",
      description =
          "Release even if README.md shows figures that an older program measured. "
              + "Without this option such a release is refused.")
  private boolean staleFigures;

  @Override
  protected void run() throws Exception {
    if ((jarOnly && publish) || (unsigned && !publish)) {
      throw wrongUsage(
          jarOnly ? "--jar-only and --publish exclude each other" : "--unsigned needs --publish");
    }
    Launcher launcher =
        Launcher.ofThisProcess()
            .orElseThrow(
                () -> wrongUsage("only the launcher can build a release: call ./simbad release"));
    Release release = Release.of(launcher, line -> err().println("release: " + line));
    if (!jarOnly && !staleFigures) {
      refuseStaleFigures(release.staleFigures());
    }
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      if (publish) {
        writeRepository(release, staged.path());
      } else if (jarOnly) {
        release.writeJar(staged.path());
      } else {
        release.write(staged.path());
      }
      staged.publish();
    }
    err().println("release: wrote " + out);
  }

  private static void refuseStaleFigures(List<String> stale) throws IOException {
    if (!stale.isEmpty()) {
      throw new IOException(
          "figures in docs/figures are of an older program: "
              + String.join(", ", stale)
              + "; measure them again (docs/figures/measure --help), or use --stale-figures");
    }
  }

  private void writeRepository(Release release, Path folder) throws Exception {
    try {
      release.writeRepository(folder, !unsigned);
    } catch (UnpublishableException e) {
      throw wrongUsage("--publish: " + e.getMessage());
    }
  }
}
