package simbad.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import simbad.experiments.dataset.LogSettings;
import simbad.experiments.dataset.MotionImport;

/**
 * {@code simbad dataset motion csv}: a person's log of a robot's motion. Picocli fills the fields
 * for the help's sake; what was typed is taken from its record of the line.
 */
@Command(
    name = "csv",
    sortOptions = false,
    abbreviateSynopsis = true,
    description = {
      "Make a motion folder from tables of your own: what the robot was told, and "
          + "where it then was.",
      "A column is given by its name or by its number from 1. What you do not say is "
          + "guessed from the columns' names, or assumed. Every assumption is printed."
    },
    footer = {
      "",
      "Example: simbad dataset motion csv my-commands.csv my-track.csv --out my-robot",
      "Example: simbad dataset motion csv my-drive.csv --left vl --right vr --wheel-base 20cm --heading"
          + " yaw --angle-unit rad --out my-robot"
    })
@SuppressWarnings("UnusedVariable")
final class DatasetMotionCsvCommand extends Subcommand {
  @Spec
  @SuppressWarnings("NullAway.Init")
  private CommandSpec self;

  @Parameters(
      arity = "1..2",
      paramLabel = "COMMANDS.csv [TRACK.csv]",
      hideParamSyntax = true,
      description = "The commands, and where the robot was. One file is enough if it has both.")
  private List<String> files = List.of();

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "The motion folder, which does not exist yet.")
  private Path out = Path.of("");

  @Option(
      names = "--time",
      paramLabel = "COLUMN",
      description = "Column with the times of the commands, and of the track.")
  private @Nullable String time;

  @Option(
      names = "--track-time",
      paramLabel = "COLUMN",
      description = "The track's column with the times, if it has another name.")
  private @Nullable String trackTime;

  @Option(
      names = "--time-unit",
      paramLabel = "UNIT",
      description = "s, ms, us, ns or min. Default: as the column's name says, else s.")
  private @Nullable String timeUnit;

  @Option(
      names = "--run",
      paramLabel = "COLUMN",
      description = "Column whose values name the recording. Default: one recording.")
  private @Nullable String run;

  @Option(
      names = "--speed",
      paramLabel = "COLUMN",
      description = "Column with the commanded speed ahead.")
  private @Nullable String speed;

  @Option(
      names = "--turn",
      paramLabel = "COLUMN",
      description = "Column with the commanded rate of turning, counter-clockwise.")
  private @Nullable String turn;

  @Option(
      names = "--left",
      paramLabel = "COLUMN",
      description = "Instead of --speed: speed of the left wheel's rim.")
  private @Nullable String left;

  @Option(names = "--right", paramLabel = "COLUMN", description = "Speed of the right wheel's rim.")
  private @Nullable String right;

  @Option(
      names = "--wheel-base",
      paramLabel = "LENGTH",
      description = "Distance between the wheels, such as 20cm.")
  private @Nullable String wheelBase;

  @Option(
      names = "--speed-unit",
      paramLabel = "UNIT",
      description = "m/s, cm/s, mm/s, in/s, ft/s. Default: as the column's name says, else m/s.")
  private @Nullable String speedUnit;

  @Option(
      names = "--turn-unit",
      paramLabel = "UNIT",
      description = "rad/s or deg/s. Default: as the column's name says, else rad/s.")
  private @Nullable String turnUnit;

  @Option(names = "--x", paramLabel = "COLUMN", description = "Column of the track: to the right.")
  private @Nullable String x;

  @Option(names = "--y", paramLabel = "COLUMN", description = "Column of the track: up the page.")
  private @Nullable String y;

  @Option(
      names = "--z",
      paramLabel = "COLUMN",
      description = "Column of the track: down the page, instead of --y.")
  private @Nullable String z;

  @Option(
      names = "--place-unit",
      paramLabel = "UNIT",
      description = "Unit of the places. Default: as the columns' names say, else m.")
  private @Nullable String placeUnit;

  @Option(
      names = "--heading",
      paramLabel = "COLUMN",
      description = "Column of the track: the robot's heading.")
  private @Nullable String heading;

  @Option(
      names = "--angle-unit",
      paramLabel = "UNIT",
      description = "deg, rad, gon or turn. Default: as the column's name says, else deg.")
  private @Nullable String angleUnit;

  @Option(
      names = "--angle-positive",
      paramLabel = "ccw|cw",
      description = "Direction in which headings grow, seen from above. Default: ccw.")
  private @Nullable String anglePositive;

  @Option(
      names = "--angle-zero",
      paramLabel = "WHERE",
      description = "Direction of heading 0: right, up, left, down or an angle. Default: right.")
  private @Nullable String angleZero;

  @Option(
      names = "--track-sigma",
      paramLabel = "LENGTH",
      description = "Standard deviation of the track's places, such as 2mm. Default: 1mm.")
  private @Nullable String trackSigma;

  @Option(
      names = "--heading-sigma",
      paramLabel = "ANGLE",
      description = "Standard deviation of the track's headings. Default: 0.1deg.")
  private @Nullable String headingSigma;

  @Option(
      names = "--clocks",
      paramLabel = "one|separate",
      description = "Whether one clock gave the times of commands and track. Default: one.")
  private @Nullable String clocks;

  @Option(
      names = "--separator",
      paramLabel = "WORD",
      description = "comma, semicolon, tab, bar or blanks, if it is not recognized.")
  private @Nullable String separator;

  @Option(
      names = "--decimal",
      paramLabel = "point|comma",
      description = "Decimal mark of the numbers, if it is not recognized.")
  private @Nullable String decimal;

  @Option(names = "--skip", paramLabel = "N", description = "Number of lines before the table.")
  private @Nullable String skip;

  @Override
  protected void run() throws Exception {
    LogSettings said = CsvOptions.typed(self);
    Path commands = Path.of(files.get(0));
    Path track = Path.of(files.get(files.size() - 1));
    MotionImport.Made made = MotionImport.of(commands, track, said);
    DatasetMotionCommand.publish(made.data(), out);
    made.assumptions().forEach(assumption -> out().println("assumed: " + assumption));
    made.notes().forEach(note -> out().println("read: " + note));
    out().println(made.summary());
    List<String> words = new ArrayList<>(List.of("./simbad", "dataset", "motion", "csv"));
    words.addAll(files);
    words.addAll(said.words());
    words.addAll(List.of("--out", out.toString()));
    out().println("again: " + DatasetCsvCommand.line(words));
  }
}
