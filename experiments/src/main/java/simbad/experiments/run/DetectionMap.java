package simbad.experiments.run;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import javax.vecmath.Vector3d;
import simbad.gui.Simbatch;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.shape.DetectionShadow;

/**
 * How often a belt disagrees with the table, over a square of places round the obstacle.
 *
 * <p>The table says of a place whether the obstacle is heard there by a sensor that looks at it; a
 * belt that looks all round should hear it there and nowhere else, whatever its heading. A sensor
 * with memory forgets from place to place.
 *
 * @param disagreement per place, share of the belt's headings
 * @param agreement over all places and headings, in [0, 1]
 */
public record DetectionMap(ShareGrid disagreement, double agreement) {
  /** Checks the agreement. */
  public DetectionMap {
    Checks.share("agreement", agreement);
  }

  /** Places along each side of the square. */
  public static final int CELLS = 81;

  /** Headings of the belt at each place, uniform by chance. */
  public static final int HEADINGS = 6;

  private static final double MARGIN = 1.15;

  /**
   * Returns how often the belt missed the obstacle where the table says that it is heard.
   *
   * @param shadow of the table
   * @return share of the places in the shadow and their headings, in [0, 1]; 0 if none is in it
   */
  public double missedShare(DetectionShadow shadow) {
    int cells = disagreement.cells();
    return IntStream.range(0, cells * cells)
        .filter(i -> shadow.contains(placeOf(i)))
        .mapToDouble(i -> disagreement.shares().get(i))
        .average()
        .orElse(0);
  }

  /** Returns the number of poses: places times headings. */
  public int poses() {
    return disagreement.cells() * disagreement.cells() * HEADINGS;
  }

  private Point placeOf(int index) {
    int cells = disagreement.cells();
    return new Point(disagreement.centreM(index % cells), disagreement.centreM(index / cells));
  }

  /** Measures one belt. */
  static DetectionMap of(ObstacleType type, SensorKind sensor, RunSettings settings) {
    SplittableRandom random = new SplittableRandom(~Circuit.seed(type, sensor, settings.seed()));
    RangeSensorBelt belt = sensor.beltWithoutMemory(settings.sonar(), random);
    Probe probe = new Probe(type, belt, settings.sonar().mountHeightM());
    DetectionShadow shadow = new DetectionShadow(type.thresholds().table());
    double reachM = Math.max(type.thresholds().table().greatestM(), DetectionRule.ORIGINAL_RANGE_M);
    ShareGrid grid =
        ShareGrid.of(
            CELLS,
            MARGIN * reachM,
            (xM, zM) -> {
              boolean expected = shadow.contains(new Point(xM, zM));
              int wrong = 0;
              for (int i = 0; i < HEADINGS; i++) {
                wrong += probe.hears(xM, zM, random) == expected ? 0 : 1;
              }
              return wrong / (double) HEADINGS;
            });
    probe.dispose();
    double mean = grid.shares().stream().mapToDouble(Double::doubleValue).average().orElse(0);
    return new DetectionMap(grid, 1 - mean);
  }

  /** A robot that stands where it is put and pings once. */
  private static final class Probe {
    private final FollowerRobot robot;
    private final Simbatch simulation;

    Probe(ObstacleType type, RangeSensorBelt belt, double mountHeightM) {
      robot =
          new FollowerRobot(
              Pose.of(0, 0, 0), belt, mountHeightM, (readings, command) -> command.set(0, 0));
      EnvironmentDescription environment = new EnvironmentDescription();
      environment.add(new SonarObstacle(new Vector3d(), 0, type));
      environment.add(robot);
      simulation = new Simbatch(environment, false);
      simulation.reset();
    }

    boolean hears(double xM, double zM, SplittableRandom random) {
      robot.moveToPosition(xM, zM);
      robot.rotateY(random.nextDouble() * Angles.TURN_RAD);
      simulation.step();
      return robot.hears();
    }

    void dispose() {
      simulation.dispose();
    }
  }
}
