package simbad.blindworld.world;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;

/**
 * The format's golden scenes and rows (part of the format's description, computed by its authors).
 */
final class Golden {

  static final Path FOLDER = Path.of("src/test/resources/golden");

  private Golden() {}

  static Scene scene(String name) throws IOException, FormatException {
    JsonObject json = JsonObject.read(FOLDER.resolve(name + ".scene.json"));
    List<Obstacle> obstacles = new ArrayList<>();
    for (JsonObject o : json.objects("obstacles")) {
      Point place = new Point(o.number("x_m"), o.number("z_m"));
      double turn = Math.toRadians(o.number("turn_deg"));
      Shadow shadow =
          o.has("thresholds_m")
              ? new Shadow(o.numbers("thresholds_m"))
              : Shadow.uniform(o.number("uniform_range_m"));
      obstacles.add(new Obstacle(o.text("name"), place, turn, outline(o), shadow));
    }
    return new Scene(json.number("no_echo_m"), sensor(json.object("sensor")), obstacles);
  }

  private static List<Point> outline(JsonObject obstacle) {
    List<Point> outline = new ArrayList<>();
    if (obstacle.fields().get("outline_m") instanceof List<?> points) {
      for (Object point : points) {
        List<?> xz = (List<?>) point;
        outline.add(new Point((Double) xz.get(0), (Double) xz.get(1)));
      }
    }
    return outline;
  }

  private static Sensor sensor(JsonObject json) throws FormatException {
    return new Sensor(
        json.text("name"),
        Math.toRadians(json.number("cone_half_angle_deg")),
        json.number("min_range_m"),
        json.number("max_range_m"),
        json.number("mount_height_m"),
        json.number("assumed_sound_speed_m_s"),
        json.number("resolution_m"),
        json.number("range_noise_m"),
        json.number("miss_rate"),
        json.number("edge_width_m"),
        json.number("update_period_s"));
  }

  static Recording rows(String name) throws IOException, FormatException {
    Csv csv = Csv.read(FOLDER.resolve(name + ".rows.csv"));
    List<Row> rows = new ArrayList<>();
    for (int i = 0; i < csv.size(); i++) {
      Pose pose = new Pose(csv.number(i, 3), csv.number(i, 4), Math.toRadians(csv.number(i, 5)));
      rows.add(new Row(csv.text(i, 0), csv.text(i, 1), csv.number(i, 2), pose));
    }
    return new Recording(rows);
  }
}
