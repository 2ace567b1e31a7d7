package simbad.cli;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import simbad.experiments.dataset.LogSettings;

/**
 * What can be said of a log. Picocli fills the fields for the help's sake; what was typed is taken
 * from its record of the line, word by word, so that the same can be printed again.
 */
@SuppressWarnings({"UnusedVariable", "UnusedNestedClass"})
final class CsvOptions {
  private static final String COLUMN = "COLUMN";

  @ArgGroup(validate = false, heading = "%nReadings (a COLUMN is a name or a number from 1):%n")
  private Readings readings = new Readings();

  @ArgGroup(validate = false, heading = "%nPlaces (WHERE is a COLUMN, or a value with its unit):%n")
  private Places places = new Places();

  @ArgGroup(validate = false, heading = "%nTarget and sonar:%n")
  private Believed believed = new Believed();

  @ArgGroup(validate = false, heading = "%nThe file's form, where it is not recognized:%n")
  private Written written = new Written();

  /** What the columns of readings are. */
  private static final class Readings {
    @Option(
        names = "--range",
        paramLabel = "COLUMNS",
        description = "Column with the ranges. Several columns: a,b or m1-m10.")
    private @Nullable String range;

    @Option(
        names = "--range-unit",
        paramLabel = "UNIT",
        description =
            "cm, mm, m, in, ft; or us, ms, s for the time of flight there and back. "
                + "Default: the unit in the column's name.")
    private @Nullable String rangeUnit;

    @Option(
        names = "--no-echo",
        paramLabel = "CODES",
        description =
            "Values that mean no echo, such as 0,765 or '>=400'. Empty cells and NaN "
                + "always do.")
    private @Nullable String noEcho;

    @Option(
        names = "--wide",
        paramLabel = "repeats|sensors",
        description =
            "Meaning of several range columns: sensors or repeats. Default: sensors if "
                + "--mount names them.")
    private @Nullable String wide;

    @Option(
        names = "--time",
        paramLabel = COLUMN,
        description =
            "Column with the times: numbers, times of day or dates. Without it the data "
                + "set has no times.")
    private @Nullable String time;

    @Option(names = "--time-unit", paramLabel = "UNIT", description = "s, ms, us, ns or min.")
    private @Nullable String timeUnit;

    @Option(
        names = "--period",
        paramLabel = "TIME",
        description = "Time from ping to ping, such as 60ms, if the log has no times.")
    private @Nullable String period;

    @Option(
        names = "--run",
        paramLabel = "COLUMNS",
        description =
            "Columns whose values name the recording. Default: each file is one recording.")
    private @Nullable String run;

    @Option(
        names = "--sensor",
        paramLabel = COLUMN,
        description = "Column with the sensors' names.")
    private @Nullable String sensor;

    @Option(
        names = "--placement",
        paramLabel = COLUMN,
        description =
            "Column whose value stays the same while nothing is moved. Default: "
                + "neighbouring rows with equal places belong together.")
    private @Nullable String placement;

    @Option(
        names = "--temperature",
        paramLabel = "WHERE",
        description = "Temperature of the air, degrees Celsius.")
    private @Nullable String temperature;

    @Option(
        names = "--gap-ms",
        paramLabel = "WHERE",
        description = "Column: milliseconds from the previous ping to this one.")
    private @Nullable String gap;

    @Option(
        names = "--pause-ms",
        paramLabel = "WHERE",
        description = "Column: milliseconds from the previous echo to this ping.")
    private @Nullable String pause;

    @Option(
        names = "--only",
        paramLabel = "COLUMN=VALUE",
        description = "Take only these rows. For numbers: COLUMN=LEAST..MOST. May be repeated.")
    private @Nullable List<String> only;

    @Option(
        names = "--without",
        paramLabel = "COLUMN=VALUE",
        description = "Leave these rows out. May be repeated.")
    private @Nullable List<String> without;
  }

  /** Where things were. */
  private static final class Places {
    @Option(
        names = "--distance",
        paramLabel = "WHERE",
        description =
            "The true distance to a target that the sensor faces (a ladder of distances). "
                + "'header': the columns' names are the distances.")
    private @Nullable String distance;

    @Option(names = "--distance-unit", paramLabel = "UNIT", description = "m, cm, mm, in, ft.")
    private @Nullable String distanceUnit;

    @Option(
        names = "--distance-to",
        paramLabel = "surface|centre",
        description =
            "The distance is measured to the target's surface or to its centre. Default: "
                + "surface; centre if the target is turned.")
    private @Nullable String distanceTo;

    @Option(
        names = "--moves",
        paramLabel = "sensor|target",
        description =
            "The sensor or the target is moved from distance to distance. Default: sensor.")
    private @Nullable String moves;

    @Option(
        names = "--bearing",
        paramLabel = "WHERE",
        description = "With --distance: the bearing of the sensor as seen from the target.")
    private @Nullable String bearing;

    @Option(names = "--x", paramLabel = "WHERE", description = "The sensor's place: to the right.")
    private @Nullable String x;

    @Option(names = "--z", paramLabel = "WHERE", description = "The sensor's place: down the page.")
    private @Nullable String z;

    @Option(
        names = "--y",
        paramLabel = "WHERE",
        description = "The sensor's place: up the page, instead of --z.")
    private @Nullable String y;

    @Option(names = "--pose-unit", paramLabel = "UNIT", description = "Unit of all places.")
    private @Nullable String poseUnit;

    @Option(
        names = "--origin",
        paramLabel = "X,Z",
        description = "The target's place in the log's numbers. Default: 0,0.")
    private @Nullable String origin;

    @Option(
        names = "--heading",
        paramLabel = "WHERE",
        description = "Direction in which the sensor or the robot looks. Default: to the target.")
    private @Nullable String heading;

    @Option(
        names = "--pan",
        paramLabel = "WHERE",
        description = "How far the sensor is turned away from the heading.")
    private @Nullable String pan;

    @Option(names = "--angle-unit", paramLabel = "UNIT", description = "deg, rad, gon or turn.")
    private @Nullable String angleUnit;

    @Option(
        names = "--angle-positive",
        paramLabel = "ccw|cw",
        description = "Direction in which angles grow, seen from above. Default: ccw.")
    private @Nullable String anglePositive;

    @Option(
        names = "--angle-zero",
        paramLabel = "right|up|left|down|ANGLE",
        description = "Direction of heading 0. Default: right.")
    private @Nullable String angleZero;

    @Option(
        names = "--target-turn",
        paramLabel = "WHERE",
        description = "How far the target is turned.")
    private @Nullable String targetTurn;

    @Option(
        names = "--target-x",
        paramLabel = "WHERE",
        description = "The target's place, if it is moved: x (to the right).")
    private @Nullable String targetX;

    @Option(
        names = "--target-z",
        paramLabel = "WHERE",
        description = "The target's place, if it is moved: z (down the page).")
    private @Nullable String targetZ;

    @Option(
        names = "--target-y",
        paramLabel = "WHERE",
        description = "The target's place, if it is moved: y (up the page), instead of z.")
    private @Nullable String targetY;

    @Option(
        names = "--mount",
        paramLabel = "SENSOR=X,Z,TURN",
        description =
            "The places in the log are the robot's, and a sensor sits on it: forward, to "
                + "the right, turned to the left, such as left=5cm,-8cm,90deg. SENSOR is its "
                + "column of ranges, or what stands in the column of --sensor. Repeat it for each.")
    private @Nullable List<String> mount;

    @Option(
        names = "--pose-sigma",
        paramLabel = "LENGTH",
        description = "Standard deviation of the places, such as 3mm.")
    private @Nullable String poseSigma;

    @Option(
        names = "--heading-sigma",
        paramLabel = "ANGLE",
        description =
            "Standard deviation of the headings. Default: 1deg where the sensor stands and looks"
                + " around, as on a servo, else 0.")
    private @Nullable String headingSigma;
  }

  /** What the simulator believes. */
  private static final class Believed {
    @Option(
        names = "--target",
        paramLabel = "SHAPE",
        description =
            "board:1.2m, 'board:1.2m x 0.4m', round:30mm (its diameter), square:25mm, a type "
                + "(simbad table types) or the file of an outline. @X,Z,TURN after it says where it "
                + "stands. Default with --distance: board:1.2m.")
    private @Nullable List<String> target;

    @Option(
        names = "--detection",
        paramLabel = "HOW",
        description =
            "Where the target is heard: uniform:2.5m, a type's table, or TABLE.csv. "
                + "Default: uniform, up to the greatest range.")
    private @Nullable String detection;

    @Option(
        names = "--scene",
        paramLabel = "FILE",
        description = "A scene.json that replaces the options for target and sonar.")
    private @Nullable String scene;

    @Option(
        names = "--sonar",
        paramLabel = "NAME|FILE",
        description = "hc-sr04, srf04, maxbotix-lv-ez1, or a sensor's JSON file.")
    private @Nullable String sonar;

    @Option(
        names = "--min-range",
        paramLabel = "LENGTH",
        description = "Smallest range that the sonar reports.")
    private @Nullable String minRange;

    @Option(
        names = "--max-range",
        paramLabel = "LENGTH",
        description = "Greatest range that the sonar reports.")
    private @Nullable String maxRange;

    @Option(
        names = "--resolution",
        paramLabel = "LENGTH",
        description = "Step of the ranges. Default: what the digits in the log show.")
    private @Nullable String resolution;

    @Option(
        names = "--cone",
        paramLabel = "ANGLE",
        description = "Half of the cone's opening angle.")
    private @Nullable String cone;

    @Option(
        names = "--height",
        paramLabel = "LENGTH",
        description = "Height of the sonar above the floor.")
    private @Nullable String height;

    @Option(
        names = "--sound-speed",
        paramLabel = "M_PER_S",
        description = "Speed of sound that the ranges were computed with. Default: the sonar's.")
    private @Nullable String soundSpeed;

    @Option(
        names = "--compensated",
        paramLabel = "true|false",
        description = "Whether the sensor itself corrects its ranges for the temperature.")
    private @Nullable String compensated;
  }

  /** How the log is written. */
  private static final class Written {
    @Option(
        names = "--separator",
        paramLabel = "WORD",
        description = "comma, semicolon, tab, bar or blanks.")
    private @Nullable String separator;

    @Option(
        names = "--decimal",
        paramLabel = "point|comma",
        description = "Decimal mark of the numbers.")
    private @Nullable String decimal;

    @Option(
        names = "--encoding",
        paramLabel = "NAME",
        description = "Encoding of the file, such as latin1.")
    private @Nullable String encoding;

    @Option(
        names = "--header",
        paramLabel = "yes|no",
        description = "Whether the first line holds the columns' names.")
    private @Nullable String header;

    @Option(names = "--skip", paramLabel = "N", description = "Number of lines before the table.")
    private @Nullable String skip;

    @Option(
        names = "--comment",
        paramLabel = "TEXT",
        description = "Text with which comment lines begin, besides #, %% and //.")
    private @Nullable String comment;

    @Option(
        names = "--skip-bad",
        description = "Leave out rows that cannot be read, and say how many.")
    private boolean skipBad;
  }

  /** What was typed, in the order of the help. */
  static LogSettings typed(CommandSpec spec) {
    ParseResult line = spec.commandLine().getParseResult();
    Map<String, List<String>> typed = new LinkedHashMap<>();
    for (OptionSpec option : spec.options()) {
      String name = option.longestName().replaceFirst("^--", "");
      if (line.hasMatchedOption(option) && !name.equals("out")) {
        boolean flag = name.equals(LogSettings.SKIP_BAD);
        typed.put(name, flag ? List.of("") : List.copyOf(option.originalStringValues()));
      }
    }
    return new LogSettings(typed);
  }
}
