package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Setup;

/** Scenes and set-ups drawn at random. */
public final class Scenes {

  private static final List<Double> STEPS_M = List.of(0.01, 0.01, 0.005, 0.02, 0.0125);
  private static final List<Double> SPEEDS = List.of(343.0, 343.0, 340.0, 331.5, 346.0);
  private static final double APART_M = 0.55;

  private Scenes() {}

  /** A scene with one to three obstacles, for a sonar that pings with the given period. */
  public static Scene draw(Chance random, double periodS) {
    Shapes shapes = new Shapes(random);
    int wanted = new int[] {1, 1, 1, 2, 2, 3}[random.nextInt(6)];
    List<Obstacle> obstacles = new ArrayList<>();
    while (obstacles.size() < wanted) {
      Point place =
          new Point(
              Shapes.rounded(random.nextDouble(-1.1, 1.1), 0.01),
              Shapes.rounded(random.nextDouble(-1.1, 1.1), 0.01));
      if (obstacles.stream().allMatch(o -> distanceM(o.place(), place) > APART_M)) {
        obstacles.add(shapes.obstacle(place, obstacles.size()));
      }
    }
    Sensor sensor = sensor(random, periodS);
    double beyond = random.nextInt(4) == 0 ? 0.5 : 0;
    return new Scene(sensor.maxRangeM() + beyond, sensor, obstacles);
  }

  private static double distanceM(Point a, Point b) {
    return StrictMath.hypot(a.xM() - b.xM(), a.zM() - b.zM());
  }

  private static Sensor sensor(Chance random, double periodS) {
    String[] names = {"SRF04", "SRF05", "HC-SR04", "ranger", "US-100"};
    return new Sensor(
        names[random.nextInt(names.length)],
        Math.toRadians(random.nextInt(24, 61) * 0.5),
        0.01 * random.nextInt(2, 7),
        0.5 * random.nextInt(6, 13),
        0.01 * random.nextInt(6, 36),
        SPEEDS.get(random.nextInt(SPEEDS.size())),
        STEPS_M.get(random.nextInt(STEPS_M.size())),
        0.001 * random.nextInt(2, 11),
        0.005 * random.nextInt(0, 6),
        0.005 * random.nextInt(2, 9),
        periodS);
  }

  /** A set-up that is a little off what the scene says of it. */
  public static Setup offSetup(Chance random, Sensor sensor) {
    return new Setup(
        sensor.edgeWidthM() * random.nextDouble(1.1, 1.9),
        sensor.missRate() + random.nextDouble(0, 0.004),
        sensor.rangeNoiseM() * random.nextDouble(0.9, 1.5),
        random.nextDouble(0.01, 0.08),
        random.nextDouble(2.5, 5),
        random.nextDouble(0, 0.35),
        new Setup.Ripple(
            random.nextDouble(0.006, 0.022),
            random.nextInt(1, 5),
            random.nextDouble(0, 2 * Math.PI)),
        Math.toRadians(random.nextDouble(0.2, 1.2)),
        Math.toRadians(random.nextDouble(-0.15, 0.15)));
  }
}
