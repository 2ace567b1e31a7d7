package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.figures.site.FigureBlocks;
import simbad.figures.site.RoomDiagram;
import simbad.figures.site.Site;
import simbad.sonar.format.TextFile;

/** {@code simbad docs}: the guides as pages, and the figures in them. */
@Command(
    name = "docs",
    description = {
      "Write the project's guides as a folder of pages with a search.",
      "Any browser opens them.",
      "With --figures it puts the measured figures of docs/figures into README.md, "
          + "draws docs/pictures/rooms.svg from the poms, and writes CITATION.cff and "
          + "codemeta.json from "
          + Publication.FILE
          + "."
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

    @Option(names = "--figures", description = "Fill the blocks of README.md, and draw the rooms.")
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
    update(readme, FigureBlocks.filled(Files.readString(readme), project.resolve("docs/figures")));
    update(project.resolve("docs/pictures/rooms.svg"), RoomDiagram.svg(project));
    Publication publication = Publication.read(project);
    update(project.resolve("CITATION.cff"), publication.citation());
    update(project.resolve("codemeta.json"), publication.codemeta());
  }

  private void update(Path file, String content) throws IOException {
    boolean same = Files.exists(file) && Files.readString(file).equals(content);
    if (!same) {
      TextFile.write(file, content);
    }
    out().println(file + (same ? ": unchanged" : ": written again"));
  }
}
