package simbad.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.dataset.Mending;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;

/** {@code simbad dataset mend}: a copy of a data set in the format's units and axes. */
@Command(
    name = "mend",
    description = {
      "Write a copy of a data set with its readings in the format's units and axes. "
          + "simbad diagnose says which options a data set needs.",
      "The options are applied in the order of this list. Other columns stay as they "
          + "are; comments are left out."
    },
    footer = {
      "",
      "Example: simbad dataset mend my-bench --out my-bench-mended --no-echo 0,7.65 --scale 0.01",
      "Example: simbad dataset mend my-bench --out my-bench-mended --flip-z --heading-radians"
    },
    sortOptions = false)
final class DatasetMendCommand extends Subcommand {
  private static final double MOST = 1e9;

  @Parameters(paramLabel = "SET", description = "The data set's folder.")
  private Path set = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "The copy's folder, which does not exist yet.")
  private Path out = Path.of("");

  @Option(
      names = "--in",
      paramLabel = "FILE",
      split = ",",
      description = "Which files to mend. Default: readings.csv and reference.csv.")
  private List<String> in = List.of(DataSetFolder.READINGS, DataSetFolder.REFERENCE);

  @Option(names = "--drop-duplicates", description = "Keep only one of several equal rows.")
  private boolean dropDuplicates;

  @Option(
      names = "--no-echo",
      paramLabel = "VALUE",
      split = ",",
      description = "Values of range_m in the file that mean no echo.")
  private List<String> noEcho = List.of();

  @Option(
      names = "--no-echo-above",
      paramLabel = "VALUE",
      description = "Values of range_m in the file above this one mean no echo.")
  private @Nullable Double noEchoAbove;

  @Option(names = "--scale", paramLabel = "F", description = "Multiply ranges.")
  private double scale = 1;

  @Option(names = "--offset", paramLabel = "M", description = "Then add this to ranges, metres.")
  private double offset;

  @Option(names = "--swap-xz", description = "Exchange x and z.")
  private boolean swap;

  @Option(names = "--flip-x", description = "In the file, x points to the left.")
  private boolean flipX;

  @Option(names = "--flip-z", description = "In the file, z points up the page.")
  private boolean flipZ;

  @Option(names = "--pose-scale", paramLabel = "F", description = "Multiply x and z.")
  private double poseScale = 1;

  @Option(names = "--heading-radians", description = "In the file, headings are in radians.")
  private boolean radians;

  @Option(names = "--heading-clockwise", description = "In the file, headings grow clockwise.")
  private boolean clockwise;

  @Option(
      names = "--heading-offset",
      paramLabel = "DEG",
      description = "Then add this to headings, degrees.")
  private double headingOffset;

  @Option(names = "--time-scale", paramLabel = "F", description = "Multiply t_s.")
  private double timeScale = 1;

  @Override
  protected void run() throws Exception {
    Mending mending = mending();
    if (mending.isNothing()) {
      throw wrongUsage(
          "nothing to mend; expected at least one of the options from --drop-duplicates on");
    }
    for (String name : in) {
      if (!List.of(DataSetFolder.READINGS, DataSetFolder.REFERENCE).contains(name)) {
        throw wrongUsage("--in: '" + name + "' is neither readings.csv nor reference.csv");
      }
    }
    new DataSetFolder(set).require();
    if (in.stream().noneMatch(name -> Files.exists(set.resolve(name)))) {
      throw DataFormatException.inFile(set, "has no " + String.join(", ", in) + " to mend");
    }
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      for (String name :
          List.of(DataSetFolder.SCENE, DataSetFolder.READINGS, DataSetFolder.REFERENCE)) {
        Path source = set.resolve(name);
        Path target = staged.path().resolve(name);
        if (in.contains(name) && (Files.exists(source) || !isOptional(name))) {
          TextFile.write(target, mending.mended(source));
        } else if (Files.exists(source) || !isOptional(name)) {
          WholeFile.write(target, Files.readAllBytes(source));
        }
      }
      staged.publish();
    }
    out().println("written to " + out);
  }

  private static boolean isOptional(String name) {
    return name.equals(DataSetFolder.REFERENCE);
  }

  private Mending mending() {
    Mending mending = new Mending();
    if (dropDuplicates) {
      mending.dropDuplicates();
    }
    ranges(mending);
    poses(mending);
    if (timeScale != 1) {
      mending.times(factor("--time-scale", timeScale));
    }
    return mending;
  }

  private void ranges(Mending mending) {
    if (!noEcho.isEmpty()) {
      mending.noEcho(noEcho);
    }
    if (noEchoAbove != null) {
      mending.noEchoAbove(within("--no-echo-above", noEchoAbove));
    }
    if (scale != 1 || offset != 0) {
      mending.range(factor("--scale", scale), within("--offset", offset));
    }
  }

  private void poses(Mending mending) {
    if (swap) {
      mending.swapAxes();
    }
    if (flipX || flipZ || poseScale != 1) {
      double times = factor("--pose-scale", poseScale);
      mending.positions(flipX ? -times : times, flipZ ? -times : times);
    }
    if (radians) {
      mending.headings(Math.toDegrees(1), 0);
    }
    if (clockwise || headingOffset != 0) {
      mending.headings(clockwise ? -1 : 1, within("--heading-offset", headingOffset));
    }
  }

  private double factor(String option, double value) {
    if (!(value > 0 && value <= MOST)) {
      throw wrongUsage(option + ": " + value + " is not in (0, " + MOST + "]");
    }
    return value;
  }

  private double within(String option, double value) {
    if (!(Math.abs(value) <= MOST)) {
      throw wrongUsage(option + ": " + value + " is not in [-" + MOST + ", " + MOST + "]");
    }
    return value;
  }
}
