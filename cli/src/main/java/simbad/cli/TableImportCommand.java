package simbad.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.table.TableImport;
import simbad.sonar.format.OneLine;
import simbad.sonar.format.Provenance;
import simbad.sonar.format.TableDocument;

/** {@code simbad table import}. */
@Command(
    name = "import",
    description = {
      "Make a threshold table from any csv file.",
      "Column names, unit (m, cm, mm or inches), even spacing and order of the rows "
          + "may differ."
    },
    footer = {
      "",
      "Example: simbad table import bench.csv --out my-post.csv --provenance measured",
      "Example: simbad table import plot.csv --bearing phi --threshold cm_max --unit cm --clockwise"
          + " --out t.csv"
    })
final class TableImportCommand extends Subcommand {
  @Parameters(paramLabel = "FILE.csv", description = "A csv file with a header row.")
  private Path source = Path.of("");

  @Mixin private TableResult result = new TableResult();

  @Option(
      names = "--bearing",
      paramLabel = "COLUMN",
      description =
          "Column with the bearings, in degrees. Default: a column with a name such as "
              + "bearing, angle or deg.")
  private @Nullable String bearing;

  @Option(
      names = "--threshold",
      paramLabel = "COLUMN",
      description =
          "Column with the thresholds. Default: a column with a name such as threshold, "
              + "distance or range.")
  private @Nullable String threshold;

  @Option(
      names = "--unit",
      paramLabel = "UNIT",
      description = "m, cm, mm or in. Default: the ending of the column's name, else m.")
  private TableImport.@Nullable Unit unit;

  @Option(names = "--clockwise", description = "Bearings grow clockwise as seen from above.")
  private boolean clockwise;

  @Option(
      names = "--offset",
      paramLabel = "DEG",
      description =
          "The bearing, in the obstacle's frame, that the file calls 0. Default: ${DEFAULT-VALUE}.")
  private double offsetDeg;

  @Option(
      names = "--provenance",
      paramLabel = "WORD",
      description = "One of: ${COMPLETION-CANDIDATES}.")
  private @Nullable Provenance provenance;

  @Option(names = "--object", paramLabel = "TEXT", description = "The obstacle, in words.")
  private @Nullable String object;

  @Override
  protected void run() throws Exception {
    if (!(Math.abs(offsetDeg) <= 360)) {
      throw wrongUsage("--offset: " + offsetDeg + " is not in [-360, 360] degrees");
    }
    if (object != null && !OneLine.isText(object)) {
      throw wrongUsage(
          "--object: '"
              + object
              + "' is not a text of at most "
              + OneLine.LONGEST_TEXT
              + " characters on one line");
    }
    TableDocument document =
        new TableImport(
                Optional.ofNullable(bearing),
                Optional.ofNullable(threshold),
                Optional.ofNullable(unit),
                clockwise,
                offsetDeg)
            .read(source, header());
    result.give(document, out());
  }

  private Map<String, String> header() {
    Map<String, String> header = new LinkedHashMap<>();
    if (object != null) {
      header.put("object", object.strip());
    }
    if (provenance != null) {
      header.put("provenance", provenance.word());
    }
    header.putIfAbsent("source", "imported from " + OneLine.of(source.getFileName() + "").strip());
    return header;
  }
}
