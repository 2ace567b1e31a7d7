package simbad.scene3d;

import java.util.EnumSet;
import java.util.Set;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.LineStripArray;
import javax.media.j3d.Node;
import javax.media.j3d.Shape3D;
import javax.vecmath.Point3d;
import simbad.sonar.check.Checks;

/** The edge of a detection shadow as a line on the floor. */
public final class FloorEdge implements Animated {
  private static final float OPACITY = 0.95f;
  private static final float WIDTH_PX = 1.5f;

  /** So far above the grid and the shadow that all can be told apart. */
  private static final double LEVEL_M = 0.008;

  private final Ink ink = new Ink(Palette.LIGHT.edge(), OPACITY, WIDTH_PX).covering();
  private final Curtain curtain;

  /**
   * Creates a closed line.
   *
   * @param xM corners, at least 2, in the obstacle's own frame
   * @param zM as many
   */
  public FloorEdge(double[] xM, double[] zM) {
    Checks.numbers("xM", xM);
    Checks.numbers("zM", zM);
    int count = xM.length + 1;
    LineStripArray line = new LineStripArray(count, GeometryArray.COORDINATES, new int[] {count});
    for (int i = 0; i < count; i++) {
      int corner = i % xM.length;
      line.setCoordinate(i, new Point3d(xM[corner], LEVEL_M, zM[corner]));
    }
    curtain = new Curtain(new Shape3D(line, ink.appearance()));
  }

  @Override
  public Node node() {
    return curtain.node();
  }

  @Override
  public void capture() {
    // It goes with the obstacle, which captures where it is.
  }

  @Override
  public void show() {
    // As above.
  }

  @Override
  public void adopt(Look look) {
    curtain.set(look.draws(Layer.EDGES));
    ink.set(Palette.of(look).edge());
  }

  @Override
  public Set<Sign> signs() {
    return EnumSet.of(Sign.SHADOW, Sign.EDGE);
  }
}
