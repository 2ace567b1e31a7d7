package simbad.obstacles;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.PrismShape;
import simbad.kernel.geometry.Shape;
import simbad.scene3d.Figure;
import simbad.scene3d.FloorEdge;
import simbad.sim.BlockWorldObject;
import simbad.sim.StaticObject;
import simbad.sim.World;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.Overlap;

/**
 * An upright extrusion in the world that carries its detection shadow. Agents run against its body,
 * thin rays meet its body, and a {@link SonarBelt} hears it where its shadow says so.
 */
public class SonarObstacle extends BlockWorldObject {
  /** Height of the body in metres, well over any belt. */
  public static final double BODY_HEIGHT_M = 1.0;

  /** Height of the shadow as the window draws it: flat, it hides no robot, trail or edge. */
  private static final double DRAWN_SHADOW_M = 0.004;

  private final ObstacleType type;
  private final double reachM;

  /**
   * Places an obstacle.
   *
   * @param position middle of the bottom face, metres; copied
   * @param turnRad counter-clockwise as seen from above
   * @param type what it is
   */
  public SonarObstacle(Vector3d position, double turnRad, ObstacleType type) {
    this.type = type;
    reachM = type.outline().reachM(0, 0);
    translateTo(new Vector3d(position));
    rotateY(Checks.finite("turnRad", turnRad));
  }

  /** Returns what it is. */
  public ObstacleType type() {
    return type;
  }

  /** Returns its shadow, in its own frame. */
  public DetectionShadow shadow() {
    return new DetectionShadow(type.thresholds().table());
  }

  /** Returns how its own frame lies in the world now. */
  public Placement worldFromObstacle() {
    Transform3D transform = new Transform3D();
    Vector3d translation = new Vector3d();
    getTranslationTransform(transform);
    transform.get(translation);
    return new Placement(translation.x, translation.z, getHeadingRad());
  }

  /** Returns it as a sonar model sees it, where it is now. */
  public Obstacle asSensed() {
    return new Obstacle(
        type.name(),
        worldFromObstacle(),
        type.outline(),
        new TableDetection(type.thresholds().table()));
  }

  /**
   * Enters a world. Nothing stops it from being moved into another obstacle later.
   *
   * @throws ObstacleOverlapException if its body would lie over that of another one in that world
   */
  @Override
  protected void setWorld(World world) {
    for (StaticObject standing : world.getStaticObjects()) {
      if (standing instanceof SonarObstacle other
          && other != this
          && other.getSolid().isPresent()
          && overlaps(other)) {
        throw new ObstacleOverlapException(this, other);
      }
    }
    super.setWorld(world);
  }

  private boolean overlaps(SonarObstacle other) {
    Placement there = other.worldFromObstacle();
    if (worldFromObstacle().centreDistanceM(there.xM(), there.zM()) > reachM + other.reachM) {
      return false;
    }
    List<Outline> others = other.placedParts();
    return placedParts().stream()
        .anyMatch(part -> others.stream().anyMatch(it -> Overlap.of(part, it)));
  }

  private List<Outline> placedParts() {
    Placement placement = worldFromObstacle();
    return type.parts().stream().map(part -> part.placed(placement)).toList();
  }

  /** Returns its type and place, metres. */
  @Override
  public String toString() {
    Placement at = worldFromObstacle();
    return String.format(
        Locale.ROOT, "obstacle %s at x %.4g, z %.4g m", type.name(), at.xM(), at.zM());
  }

  /** Adds the shadow, and its edge on the floor, to what the window shows. */
  @Override
  protected void decorate(Figure figure) {
    ShadowShape.find(shadow(), DRAWN_SHADOW_M).ifPresent(figure::add);
    shadow().edge().map(SonarObstacle::line).ifPresent(figure::add);
  }

  private static FloorEdge line(Outline edge) {
    return new FloorEdge(
        IntStream.range(0, edge.size()).mapToDouble(edge::xM).toArray(),
        IntStream.range(0, edge.size()).mapToDouble(edge::zM).toArray());
  }

  @Override
  protected List<Shape> bodyShapes() {
    return type.parts().stream().map(SonarObstacle::body).toList();
  }

  private static Shape body(Outline outline) {
    double[] x = new double[outline.size()];
    double[] z = new double[outline.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = outline.xM(i);
      z[i] = outline.zM(i);
    }
    return new PrismShape(x, z, 0, BODY_HEIGHT_M);
  }
}
