package simbad.experiments.motion;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * Logs as the UTIAS data set of cooperative localization has them (Leung, Halpern, Barfoot and Liu
 * 2011): numbers between blanks, {@code #} before remarks; odometry is time, forward speed, turn
 * rate; ground truth is time, x, y up the page, heading in radians. Files may be gzipped.
 */
public final class MrclamLog {
  private static final int GZIP = 0x1f;
  private static final double TRACK_SIGMA_M = 0.001;
  private static final double TRACK_SIGMA_RAD = Math.toRadians(0.1);

  private MrclamLog() {}

  /**
   * Reads a robot's log. Times count from its first command.
   *
   * @param odometry what was commanded
   * @param groundTruth where the robot was
   * @param run name of the run
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MotionData read(Path odometry, Path groundTruth, String run)
      throws DataFormatException {
    List<double[]> commanded = rows(odometry, "time v w", 3);
    List<double[]> seen = rows(groundTruth, "time x y heading", 4);
    double start = commanded.stream().mapToDouble(row -> row[0]).min().orElse(0);
    List<Command> commands = new ArrayList<>();
    commanded.forEach(row -> commands.add(new Command(row[0] - start, row[1], row[2])));
    List<TrackPose> track = new ArrayList<>();
    for (double[] row : seen) {
      if (row[0] >= start) {
        track.add(new TrackPose(row[0] - start, row[1], row[2], row[3]));
      }
    }
    Robot exact = Robot.EXACT_UNICYCLE;
    Robot robot = new Robot(false, 0, false, TRACK_SIGMA_M, TRACK_SIGMA_RAD, exact.motion());
    return new MotionData(run, robot, List.of(new MotionRun(run, commands, track)), List.of());
  }

  private static List<double[]> rows(Path file, String columns, int count)
      throws DataFormatException {
    List<double[]> rows = new ArrayList<>();
    int line = 0;
    for (String text : text(file).split("\n", -1)) {
      line++;
      String bare = text.strip();
      if (!bare.isEmpty() && !bare.startsWith("#")) {
        rows.add(row(file, line, bare, columns, count));
      }
    }
    if (rows.isEmpty()) {
      throw DataFormatException.inFile(file, "has no rows, expected " + columns);
    }
    return rows;
  }

  private static double[] row(Path file, int line, String text, String columns, int count)
      throws DataFormatException {
    String[] fields = text.split("\\s+", -1);
    if (fields.length != count) {
      throw DataFormatException.inField(
          file, line, "row", fields.length + " numbers, expected " + columns);
    }
    double[] row = new double[count];
    for (int i = 0; i < count; i++) {
      row[i] = number(fields[i]);
      if (!(Math.abs(row[i]) <= 1e10)) {
        throw DataFormatException.inField(
            file, line, columns.split(" ", -1)[i], "'" + fields[i] + "' is not a finite number");
      }
    }
    return row;
  }

  private static double number(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  private static String text(Path file) throws DataFormatException {
    TextFile.requireFile(file);
    try {
      byte[] bytes = Files.readAllBytes(file);
      if (bytes.length == 0 || bytes[0] != GZIP) {
        return new String(bytes, StandardCharsets.UTF_8);
      }
      try (GZIPInputStream packed = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
        return new String(packed.readAllBytes(), StandardCharsets.UTF_8);
      }
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
  }
}
