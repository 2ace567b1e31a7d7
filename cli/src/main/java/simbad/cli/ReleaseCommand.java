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

  @Override
  protected void run() throws Exception {
    Launcher launcher =
        Launcher.ofThisProcess()
            .orElseThrow(
                () -> wrongUsage("only the launcher can build a release: call ./simbad release"));
    Release release = Release.of(launcher, line -> err().println("release: " + line));
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      if (jarOnly) {
        release.writeJar(staged.path());
      } else {
        release.write(staged.path());
      }
      staged.publish();
    }
    err().println("release: wrote " + out);
  }
}
