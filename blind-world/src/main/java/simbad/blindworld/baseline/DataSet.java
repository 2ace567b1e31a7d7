package simbad.blindworld.baseline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;

/** Reads scenes and rows in the format sonar-gap/1. */
public final class DataSet {

  private static final int MOST = 100_000;

  private DataSet() {}

  /** What a scene.json says. */
  public static Scene scene(Path file) throws IOException, FormatException {
    JsonObject json = JsonObject.read(file);
    List<Obstacle> obstacles = new ArrayList<>();
    for (JsonObject obstacle : json.objects("obstacles")) {
      obstacles.add(obstacle(obstacle));
    }
    try {
      return new Scene(json.number("no_echo_m"), sensor(json.object("sensor")), obstacles);
    } catch (IllegalArgumentException e) {
      throw new FormatException(file + ", " + e.getMessage());
    }
  }

  private static Obstacle obstacle(JsonObject json) throws FormatException {
    Point place = new Point(json.number("x_m"), json.number("z_m"));
    double turn = Math.toRadians(json.number("turn_deg"));
    List<Point> outline = new ArrayList<>();
    try {
      for (List<Double> xz : json.numberLists("outline_m")) {
        if (xz.size() != 2) {
          throw new FormatException(json.where() + ", outline_m: expected pairs");
        }
        outline.add(new Point(xz.get(0), xz.get(1)));
      }
      Shadow shadow =
          json.text("detection").equals("table")
              ? new Shadow(json.numbers("thresholds_m"))
              : Shadow.uniform(json.number("uniform_range_m"));
      return new Obstacle(json.text("name"), place, turn, outline, shadow);
    } catch (IllegalArgumentException e) {
      throw new FormatException(json.where() + ", " + e.getMessage());
    }
  }

  private static Sensor sensor(JsonObject json) throws FormatException {
    return new Sensor(
        json.text("name"),
        Math.toRadians(json.within("cone_half_angle_deg", 0, 89)),
        json.within("min_range_m", 0, MOST),
        json.within("max_range_m", 0, MOST),
        json.number("mount_height_m"),
        json.number("assumed_sound_speed_m_s"),
        json.within("resolution_m", 0, MOST),
        json.within("range_noise_m", 0, MOST),
        json.within("miss_rate", 0, 1),
        json.within("edge_width_m", 0, MOST),
        json.number("update_period_s"));
  }

  /** The rows of a file in the columns of readings.csv; its ranges are not looked at. */
  public static Recording rows(Csv csv) throws FormatException {
    int run = csv.column("run");
    int sensor = csv.column("sensor");
    int t = csv.column("t_s");
    int x = csv.column("x_m");
    int z = csv.column("z_m");
    int heading = csv.column("heading_deg");
    List<Row> rows = new ArrayList<>();
    for (int i = 0; i < csv.size(); i++) {
      Pose pose =
          new Pose(csv.number(i, x), csv.number(i, z), Math.toRadians(csv.number(i, heading)));
      rows.add(new Row(csv.text(i, run), csv.text(i, sensor), csv.number(i, t), pose));
    }
    return new Recording(rows);
  }

  /** The readings of a file; infinite is a no-echo. */
  static double[] ranges(Csv csv) throws FormatException {
    int range = csv.column("range_m");
    double[] ranges = new double[csv.size()];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = csv.text(i, range).isBlank() ? Double.POSITIVE_INFINITY : csv.number(i, range);
    }
    return ranges;
  }
}
