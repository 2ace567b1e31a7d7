package simbad.cli;

import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.cli.machine.Launcher;

/** {@code simbad release}. */
@Command(
    name = "release",
    description = {
      "Make a release of the current commit: one jar with everything, the sources, the Javadoc, an"
          + " SBOM, the licences of all that it brings along, the changelog, checksums.",
      "The same commit gives the same bytes. Files that differ from the commit have no part in it."
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
      description = "Make simbad.jar and nothing else, quickly: for programs that use it.")
  private boolean jarOnly;

  @Option(
      names = "--publish",
      description =
          "Make what a Maven repository takes instead, as a folder to be handed in. Needs gpg, and"
              + " what "
              + Publication.FILE
              + " asks for.")
  private boolean publish;

  @Option(names = "--unsigned", description = "With --publish: without signatures, to look at it.")
  private boolean unsigned;

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

  private void writeRepository(Release release, Path folder) throws Exception {
    try {
      release.writeRepository(folder, !unsigned);
    } catch (UnpublishableException e) {
      throw wrongUsage("--publish: " + e.getMessage());
    }
  }
}
