package simbad.cli;

import java.nio.file.Path;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import simbad.bench.capture.ThesisCapture;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;

/** {@code simbad bench import}. */
@Command(
    name = "import",
    description = {
      "Make a table from a capture in the thesis's form: one number per line, in "
          + "steps of 2 cm, for each bearing from 0 all round.",
      "The numbers are distances to the surface. The distance from the surface to "
          + "the axis is added."
    },
    footer = {"", "Example: simbad bench import numbers.txt --obstacle angle --out mine.csv"})
final class BenchImportCommand extends Subcommand {
  @Parameters(paramLabel = "FILE", description = "The numbers.")
  private Path numbers = Path.of("");

  @Mixin private SweptObstacle obstacle = new SweptObstacle();

  @Mixin private TableOutput output = new TableOutput();

  @Override
  protected void run() throws Exception {
    Path file = output.file();
    ObstacleType type = obstacle.type();
    TableDocument table;
    try {
      table = ThesisCapture.read(numbers, type.name(), type.outline(), obstacle.temperatureC());
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e);
    }
    TableFile.write(file, table);
    out()
        .printf(
            Locale.ROOT,
            "%s: %d bearings, up to %.2f m%n",
            file,
            table.table().size(),
            table.table().greatestM());
  }
}
