package simbad.experiments.cli;

import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.bench.capture.ThesisCapture;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;

/** {@code simbad bench import}. */
@Command(
    name = "import",
    description = {
      "Make a table of a capture as the thesis made it: a number in steps of 2 cm for each bearing,"
          + " one on a line, from bearing 0 all round.",
      "The numbers tell the distance to the surface; that to the axis is added."
    },
    footer = {"", "Example: simbad bench import numbers.txt --obstacle angle --out mine.csv"})
final class BenchImportCommand extends Subcommand {
  @Parameters(paramLabel = "FILE", description = "The numbers.")
  private Path numbers = Path.of("");

  @Option(
      names = "--obstacle",
      paramLabel = "NAME",
      required = true,
      description = "What was swept: square, round, angle; its cross-section is needed.")
  private String obstacle = "";

  @Option(
      names = "--temperature",
      paramLabel = "CELSIUS",
      description = "Of the air. Default: not known, 20 assumed.")
  private @Nullable Double temperatureC;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      required = true,
      description = "A file that does not exist yet.")
  private Path file = Path.of("");

  @Override
  protected void run() throws Exception {
    if (Files.exists(file)) {
      throw new FileAlreadyExistsException(file.toString());
    }
    ObstacleType type = ObstacleArgument.parse(obstacle);
    OptionalDouble degreesC =
        temperatureC == null ? OptionalDouble.empty() : OptionalDouble.of(temperatureC);
    TableDocument table;
    try {
      table = ThesisCapture.read(numbers, type.name(), type.outline(), degreesC);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(String.valueOf(e.getMessage()));
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
