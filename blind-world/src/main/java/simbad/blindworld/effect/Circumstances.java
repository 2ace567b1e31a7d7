package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.Sight;
import simbad.blindworld.world.World;

/**
 * Where an effect is to be put in: what its size may depend on, and chance.
 *
 * <p>{@code strength} is 1 for a practical size and 0 for a form that changes nothing.
 */
public final class Circumstances {

  private static final double HEARD = 0.5;
  private static final int LEAST_READINGS = 3;

  private final Scene scene;
  private final Recording recording;
  private final boolean driven;
  private final RandomGenerator random;
  private final double strength;
  private final List<Double> distancesM;

  /** A scene, a recording that is typical of the design, whether a robot drives, chance, a size. */
  public Circumstances(
      Scene scene, Recording recording, boolean driven, RandomGenerator random, double strength) {
    this.scene = scene;
    this.recording = recording;
    this.driven = driven;
    this.random = random;
    this.strength = Checks.notNegative("strength", strength);
    this.distancesM = heard(scene, recording);
  }

  private static List<Double> heard(Scene scene, Recording recording) {
    World.Listening nominal =
        new World(scene, Setup.nominal(scene.sensor()), List.of()).at(recording);
    List<Double> distances = new ArrayList<>();
    for (int row = 0; row < recording.size(); row++) {
      double nearest = Double.POSITIVE_INFINITY;
      for (Sight sight : nominal.sights().get(row)) {
        if (nominal.chance(row, sight) > HEARD) {
          nearest = Math.min(nearest, sight.distanceM());
        }
      }
      if (nearest < Double.POSITIVE_INFINITY) {
        distances.add(nearest);
      }
    }
    distances.sort(null);
    return List.copyOf(distances);
  }

  /** What the simulator believes. */
  public Scene scene() {
    return scene;
  }

  /** The sonar of the scene. */
  public Sensor sensor() {
    return scene.sensor();
  }

  /** A recording of the design. */
  public Recording recording() {
    return recording;
  }

  /** True when a robot drives, false on a bench. */
  public boolean driven() {
    return driven;
  }

  /** True when it was read several times at most places. */
  public boolean placed() {
    return !driven && recording.size() >= LEAST_READINGS * recording.placements().size();
  }

  /** True when there is more than one transducer. */
  public boolean severalSensors() {
    return recording.sensors().size() > 1;
  }

  /** True when some obstacle's threshold is believed uniform. */
  public boolean someUniform() {
    return scene.obstacles().stream().anyMatch(o -> o.shadow().isUniform());
  }

  /** True when some obstacle has a table. */
  public boolean someTable() {
    return scene.obstacles().stream().anyMatch(o -> !o.shadow().isUniform());
  }

  /** The share of rows on which an echo is to be expected. */
  public double echoShare() {
    return (double) distancesM.size() / recording.size();
  }

  /** A quantile of the distances at which echoes are to be expected, in metres. */
  public double distanceM(double quantile) {
    if (distancesM.isEmpty()) {
      return 1;
    }
    return distancesM.get((int) Math.min(distancesM.size() - 1.0, quantile * distancesM.size()));
  }

  /** The practical size times the strength. */
  public double sized(double practical) {
    return practical * strength;
  }

  /** The practical size times the strength, up or down by chance. */
  public double eitherWay(double practical) {
    return random.nextBoolean() ? sized(practical) : -sized(practical);
  }

  /** The strength itself. */
  public double strength() {
    return strength;
  }

  /** Somewhere in an interval. */
  public double between(double low, double high) {
    return random.nextDouble(low, high);
  }

  /** A whole number from low to high, both included. */
  public int whole(int low, int high) {
    return random.nextInt(low, high + 1);
  }

  /** One of a list. */
  public <T> T oneOf(List<T> list) {
    return list.get(random.nextInt(list.size()));
  }

  /** One of the obstacles, by index. */
  public int obstacle() {
    return random.nextInt(scene.obstacles().size());
  }

  /** One of the transducers. */
  public String transducer() {
    return oneOf(recording.sensors());
  }

  /** Where one of the obstacles stands. */
  public Obstacle someObstacle() {
    return oneOf(scene.obstacles());
  }
}
