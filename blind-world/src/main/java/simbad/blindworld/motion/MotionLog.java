package simbad.blindworld.motion;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.world.Pose;

/**
 * A log as files hold it, in the format motion-gap/1.
 *
 * @param outing what was told, and when the tracker looked
 * @param track what it saw
 */
public record MotionLog(Outing outing, Track track) {

  /** What a robot.json says. */
  public static Robot robot(Path file) throws IOException, FormatException {
    JsonObject json = JsonObject.read(file);
    try {
      return robot(json);
    } catch (IllegalArgumentException e) {
      throw new FormatException(file + ", " + e.getMessage());
    }
  }

  private static Robot robot(JsonObject json) throws FormatException {
    boolean differential = json.text("kinematics").equals("differential");
    return new Robot(
        differential ? json.number("wheel_radius_m") : 0,
        differential ? json.within("wheel_base_m", 1e-6, 1e6) : 1,
        differential,
        new Robot.Beliefs(
            or(json, "latency_s", 0),
            or(json, "speed_time_constant_s", 0),
            or(json, "max_speed_m_s", Double.POSITIVE_INFINITY),
            or(json, "max_turn_rad_s", Double.POSITIVE_INFINITY)),
        new Robot.Scatter(
            or(json, "track_sigma_m", 0), Math.toRadians(or(json, "track_sigma_deg", 0))),
        json.has("clocks") && json.text("clocks").equals("separate"));
  }

  private static double or(JsonObject json, String name, double absent) throws FormatException {
    Optional<Double> value = json.optionalNumber(name);
    return value.orElse(absent);
  }

  /** A track by itself, with no commands. */
  public static MotionLog track(Path file) throws IOException, FormatException {
    return of(Map.of(), file);
  }

  /** Commands of a robot with its track. */
  public static MotionLog read(Path commands, Path track, Robot robot)
      throws IOException, FormatException {
    return of(commands(commands, robot), track);
  }

  private static Map<String, Commands> commands(Path file, Robot robot)
      throws IOException, FormatException {
    Csv csv = Csv.read(file);
    int first = csv.column(robot.differential() ? "left_m_s" : "v_m_s");
    int second = csv.column(robot.differential() ? "right_m_s" : "w_rad_s");
    int time = csv.column("t_s");
    Map<String, Commands> commands = new LinkedHashMap<>();
    for (Map.Entry<String, List<Integer>> run : runs(csv).entrySet()) {
      int size = run.getValue().size();
      double[] times = new double[size];
      double[] v = new double[size];
      double[] w = new double[size];
      for (int i = 0; i < size; i++) {
        int row = run.getValue().get(i);
        double a = csv.number(row, first);
        double b = csv.number(row, second);
        Commands.Speeds told =
            robot.differential()
                ? Commands.Speeds.ofRims(a, b, robot.wheelBaseM())
                : new Commands.Speeds(a, b);
        times[i] = csv.number(row, time);
        v[i] = told.vMPerS();
        w[i] = told.wRadPerS();
      }
      commands.put(run.getKey(), rising(file, times, v, w));
    }
    return commands;
  }

  private static Commands rising(Path file, double[] times, double[] v, double[] w)
      throws FormatException {
    try {
      return new Commands(times, v, w);
    } catch (IllegalArgumentException e) {
      throw new FormatException(file + ": " + e.getMessage());
    }
  }

  private static Map<String, List<Integer>> runs(Csv csv) throws FormatException {
    int run = csv.column("run");
    Map<String, List<Integer>> runs = new LinkedHashMap<>();
    for (int row = 0; row < csv.size(); row++) {
      runs.computeIfAbsent(csv.text(row, run), name -> new ArrayList<>()).add(row);
    }
    return runs;
  }

  private static MotionLog of(Map<String, Commands> commands, Path file)
      throws IOException, FormatException {
    Csv csv = Csv.read(file);
    int[] columns = {csv.column("x_m"), csv.column("z_m"), csv.column("heading_deg")};
    int time = csv.column("t_s");
    Commands none = new Commands(new double[0], new double[0], new double[0]);
    List<Outing.Run> runs = new ArrayList<>();
    List<double[][]> poses = new ArrayList<>();
    for (Map.Entry<String, List<Integer>> run : runs(csv).entrySet()) {
      int size = run.getValue().size();
      double[] frames = new double[size];
      double[][] seen = new double[3][size];
      for (int i = 0; i < size; i++) {
        int row = run.getValue().get(i);
        frames[i] = csv.number(row, time);
        for (int c = 0; c < columns.length; c++) {
          double value = csv.number(row, columns[c]);
          seen[c][i] = c == 2 ? Math.toRadians(value) : value;
        }
      }
      poses.add(seen);
      Pose start = new Pose(seen[0][0], seen[1][0], seen[2][0]);
      Commands told = commands.getOrDefault(run.getKey(), none);
      runs.add(new Outing.Run(run.getKey(), told, frames, frames[size - 1], start));
    }
    return new MotionLog(new Outing(runs), Track.of(poses));
  }
}
