package simbad.benchmarks;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import simbad.kernel.belt.BeltLayout;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;

/**
 * One reading of a belt of 12 sonars at one point, of the SRF04's figures, among obstacles with
 * threshold tables: square, round and angle in turn.
 */
@SuppressWarnings("NullAway.Init") // JMH sets the parameters before anything else.
public class ConeBeltBenchmark extends BeltBenchmark {
  private static final long SEED = 1;

  /** When an obstacle echoes. */
  @Param DetectionRule rule;

  /** Number of obstacles. */
  @Param({"1", "10", "100", "500", "1000", "5000"})
  int obstacles;

  /** Builds the scene. */
  @Setup
  public void build() {
    Grid grid = new Grid(obstacles, 1);
    List<ObstacleType> types = Catalogue.types();
    Scene scene =
        new Scene(
            IntStream.range(0, obstacles)
                .mapToObj(i -> obstacle(types.get(i % types.size()), grid.post(i)))
                .toList());
    measure(
        rule.bind(Catalogue.srf04(), scene, new SplittableRandom(SEED)),
        new Circle(grid.cell(0), BeltLayout.ring(0, 1, Arena.SONARS)));
  }

  private static Obstacle obstacle(ObstacleType type, Point at) {
    return new Obstacle(
        type.name(),
        new Placement(at.xM(), at.zM(), Belt.TURN_RAD),
        type.outline(),
        new TableDetection(type.thresholds().table()));
  }
}
