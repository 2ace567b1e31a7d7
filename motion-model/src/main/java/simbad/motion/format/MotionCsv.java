package simbad.motion.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.motion.Command;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.Unicycle;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** The two tables of a motion folder, by run in the order in which the runs first appear. */
final class MotionCsv {
  /** Faster than any robot of these logs, and farther. */
  private static final Limit GREATEST_SPEED = Limit.of(1000);

  private static final Limit GREATEST_M = Limit.of(1e7);
  private static final Limit GREATEST_DEG = Limit.of(1e9);
  private static final Limit GREATEST_S = Limit.of(1e12);
  private static final String RUN = "run";
  private static final String TIME = "t_s";

  private MotionCsv() {}

  static Map<String, List<MotionRow<Command>>> commands(Path file, Robot robot)
      throws DataFormatException {
    String first = robot.differential() ? "left_m_s" : "v_m_s";
    String second = robot.differential() ? "right_m_s" : "w_rad_s";
    CsvTable csv = table(file, first, second);
    Map<String, List<MotionRow<Command>>> runs = new LinkedHashMap<>();
    for (int row = 0; row < csv.size(); row++) {
      double one = within(GREATEST_SPEED, csv, row, first);
      double two = within(GREATEST_SPEED, csv, row, second);
      double timeS = within(GREATEST_S, csv, row, TIME);
      runs.computeIfAbsent(csv.label(row, RUN), name -> new ArrayList<>())
          .add(new MotionRow<>(row, command(robot, timeS, one, two)));
    }
    return runs;
  }

  static Map<String, List<MotionRow<TrackPose>>> track(Path file) throws DataFormatException {
    CsvTable csv = table(file, "x_m", "z_m", "heading_deg");
    Map<String, List<MotionRow<TrackPose>>> runs = new LinkedHashMap<>();
    for (int row = 0; row < csv.size(); row++) {
      runs.computeIfAbsent(csv.label(row, RUN), name -> new ArrayList<>())
          .add(
              new MotionRow<>(
                  row,
                  new TrackPose(
                      within(GREATEST_S, csv, row, TIME),
                      within(GREATEST_M, csv, row, "x_m"),
                      -within(GREATEST_M, csv, row, "z_m"),
                      Math.toRadians(within(GREATEST_DEG, csv, row, "heading_deg")))));
    }
    return runs;
  }

  private static Command command(Robot robot, double timeS, double one, double two) {
    return robot.differential()
        ? new Command(
            timeS,
            Unicycle.speedOfWheels(one, two),
            Unicycle.turnOfWheels(one, two, robot.wheelBaseM()))
        : new Command(timeS, one, two);
  }

  private static CsvTable table(Path file, String... columns) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(RUN, TIME);
    csv.requireColumns(columns);
    if (csv.size() == 0) {
      throw DataFormatException.inFile(file, "has no rows");
    }
    return csv;
  }

  /** The greatest size of a number, and what is expected in its place where it is larger. */
  private record Limit(double greatest, String expected) {
    static Limit of(double greatest) {
      return new Limit(greatest, "a finite number of at most " + greatest);
    }

    boolean allows(double value) {
      return Math.abs(value) <= greatest;
    }
  }

  private static double within(Limit limit, CsvTable csv, int row, String column)
      throws DataFormatException {
    return csv.number(row, column, limit::allows, limit.expected);
  }
}
