package simbad.blindworld.world;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Small worlds whose readings can be said in advance. */
public final class TestWorlds {

  private TestWorlds() {}

  /** A sonar without chance: no misses, no noise, no steps, a sharp edge. */
  public static Sensor sureSensor(double halfAngleDeg) {
    return new Sensor("sure", Math.toRadians(halfAngleDeg), 0.02, 5, 0.15, 343, 0, 0, 0, 1e-6, 0.1);
  }

  /** A many-cornered post of a radius at a place, heard up to a distance all round. */
  public static Obstacle post(String name, double xM, double zM, double heardM) {
    List<Point> outline =
        IntStream.range(0, 120)
            .mapToObj(
                i ->
                    new Point(0.02 * Math.cos(i * Math.PI / 60), 0.02 * Math.sin(i * Math.PI / 60)))
            .toList();
    return new Obstacle(name, new Point(xM, zM), 0, outline, Shadow.uniform(heardM));
  }

  /** Pings from -x towards the origin, from a distance to another, half a second in all. */
  public static Recording approach(double fromM, double toM, int pings) {
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < pings; k++) {
      double away = fromM + (toM - fromM) * k / (pings - 1);
      rows.add(new Row("r", "s", 0.1 * k, new Pose(-away, 0, 0)));
    }
    return new Recording(rows);
  }

  /** The readings of a world without chance. */
  public static double[] read(Scene scene, Recording recording, List<Change> changes) {
    return new World(scene, Setup.nominal(scene.sensor()), changes).at(recording).read(1);
  }
}
