package simbad.benchmarks;

import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import simbad.kernel.belt.BeltLayout;
import simbad.kernel.belt.RaySensor;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.scene.BodyScene;
import simbad.kernel.scene.Solid;
import simbad.sonar.frame.Point;

/** One reading of a belt of 12 thin rays of 1.5 m among boxes. */
public class RayBeltBenchmark extends BeltBenchmark {
  private static final float RADIUS_M = 0.3f;
  private static final float RANGE_M = 1.5f;

  /** Number of boxes. */
  @Param({"1", "10", "100", "500", "5000"})
  int boxes;

  private final BeltLayout layout = BeltLayout.ring(RADIUS_M, RANGE_M, Arena.SONARS);

  /** Builds the scene. */
  @Setup
  public void build() {
    Grid grid = new Grid(boxes, 1);
    BodyScene scene = new BodyScene();
    for (int i = 0; i < boxes; i++) {
      scene.addFixed(box(grid.post(i)));
    }
    measure(
        new RaySensor(scene, new Solid(new Placement()), layout), new Circle(grid.cell(0), layout));
  }

  private static Solid box(Point at) {
    double side = Arena.BOX_M;
    return new Solid(Placement.at(at.xM(), side / 2, at.zM()))
        .add(BoxShape.ofSides(side, side, side));
  }
}
