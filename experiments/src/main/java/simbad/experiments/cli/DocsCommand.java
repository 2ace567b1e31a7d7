package simbad.experiments.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.experiments.site.FigureBlocks;
import simbad.experiments.site.Site;

/** {@code simbad docs}: the guides as pages, and the figures in them. */
@Command(
    name = "docs",
    description = {
      "Write the project's guides as a folder of pages with a search, to be opened with any"
          + " browser.",
      "Or, with --figures, put the measured figures of docs/figures into README.md."
    },
    footer = {"", "Example: simbad docs --out site", "Example: simbad docs --figures"})
final class DocsCommand extends Subcommand {
  @ArgGroup(multiplicity = "1")
  @SuppressWarnings("NullAway.Init")
  private What what;

  /** Exactly one of them. */
  static final class What {
    @Option(names = "--out", paramLabel = "DIR", description = "A folder that does not exist yet.")
    private @Nullable Path out;

    @Option(names = "--figures", description = "Fill README.md's blocks of figures.")
    @SuppressWarnings("UnusedVariable") // Its being given is all: out is not, then.
    private boolean figures;
  }

  @Override
  protected void run() throws Exception {
    Path project = ProjectFolder.find();
    if (what.out == null) {
      fill(project);
      return;
    }
    try (StagedDirectory staged = StagedDirectory.beside(what.out)) {
      int pages = Site.write(project, staged.path());
      staged.publish();
      out().println(pages + " pages in " + what.out.resolve("index.html"));
    }
  }

  private void fill(Path project) throws IOException {
    Path readme = project.resolve("README.md");
    String page = Files.readString(readme);
    String filled = FigureBlocks.filled(page, project.resolve("docs").resolve("figures"));
    if (!filled.equals(page)) {
      Files.writeString(readme, filled);
    }
    out().println(readme + (filled.equals(page) ? ": as measured" : ": written anew"));
  }
}
