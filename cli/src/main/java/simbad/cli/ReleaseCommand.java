package simbad.cli;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Stands in the help for what the launcher does itself, because it builds. */
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
      "How to publish one: docs/guide/release.md",
    })
final class ReleaseCommand extends Subcommand {
  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "A folder that does not exist yet.")
  @SuppressWarnings("UnusedVariable") // the launcher's
  private @Nullable Path out;

  @Override
  protected void run() {
    throw wrongUsage("only the launcher can build a release: call ./simbad release");
  }
}
