package simbad.scene3d;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.function.IntSupplier;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.LineStripArray;
import javax.media.j3d.Shape3D;
import javax.media.j3d.Transform3D;
import javax.vecmath.Vector3d;
import simbad.sonar.check.Checks;

/**
 * A line on the floor where an agent has been. It knows what it saw: an agent that jumps, or that
 * did many steps meanwhile, and a reset begin it anew.
 */
public final class Trail implements Animated {
  private static final int CAPACITY = 2048;
  private static final float OPACITY = 0.9f;
  private static final float WIDTH_PX = 3;

  /** So far above the edges of shadows that both can be told apart. */
  private static final double LEVEL_M = 0.012;

  /** What an agent covers in one step at most: 10 m/s at the usual 20 steps per second. */
  private static final double FARTHEST_STEP_M = 0.5;

  /** Steps from one look at the agent to the next within which its way is known well enough. */
  private static final int MOST_STEPS = 200;

  private final Figure figure;
  private final IntSupplier counter;
  private final double belowM;
  private final TrailPoints points;
  private final BranchGroup group = new BranchGroup();
  private final Curtain curtain;
  private final Ink ink = new Ink(Palette.LIGHT.trail(), OPACITY, WIDTH_PX).covering();
  private final LineStripArray line =
      new LineStripArray(CAPACITY, GeometryArray.COORDINATES, new int[] {2});
  private final Transform3D pose = new Transform3D();
  private final Vector3d place = new Vector3d();
  private final Vector3d former = new Vector3d();
  private int steps;
  private int stepsCaptured;
  private int sizeShown;

  /**
   * Creates the trail of an agent that has been nowhere.
   *
   * @param figure shows the agent, and is captured before this trail; followed
   * @param counter the agent's steps since the last reset
   * @param belowM how far the agent's base is below its middle, metres
   * @param spacingM least distance between two points
   */
  public Trail(Figure figure, IntSupplier counter, double belowM, double spacingM) {
    this.figure = figure;
    this.counter = counter;
    this.belowM = Checks.number("belowM", belowM);
    points = new TrailPoints(CAPACITY, Checks.notNegative("spacingM", spacingM));
    line.setCapability(GeometryArray.ALLOW_COORDINATE_WRITE);
    line.setCapability(GeometryArray.ALLOW_COUNT_WRITE);
    Shape3D shape = new Shape3D(line, ink.appearance());
    curtain = new Curtain(shape);
    group.addChild(curtain.node());
  }

  @Override
  public BranchGroup node() {
    return group;
  }

  @Override
  public void capture() {
    stepsCaptured = counter.getAsInt();
  }

  @Override
  public void show() {
    int done = stepsCaptured - steps;
    steps = stepsCaptured;
    figure.get(pose);
    pose.get(place);
    place.y += LEVEL_M - belowM;
    if (done < 0 || done > MOST_STEPS || isJump(done)) {
      points.clear();
    }
    if (figure.isPresent() && (points.size() == 0 || !place.equals(former))) {
      former.set(place);
      draw(points.visit(place.x, place.y, place.z));
    }
  }

  private boolean isJump(int done) {
    return points.jumpM(place.x, place.y, place.z) > FARTHEST_STEP_M * Math.max(1, done);
  }

  private void draw(boolean all) {
    int size = points.size();
    double[] from = points.coordinates();
    int first = all && size != sizeShown + 1 ? 0 : Math.max(0, size - 2);
    line.setCoordinates(first, Arrays.copyOfRange(from, 3 * first, 3 * size));
    if (size != sizeShown) {
      sizeShown = size;
      line.setStripVertexCounts(new int[] {size});
    }
  }

  @Override
  public void adopt(Look look) {
    curtain.set(look.draws(Layer.TRAILS));
    ink.set(Palette.of(look).trail());
  }

  @Override
  public Set<Sign> signs() {
    return EnumSet.of(Sign.TRAIL);
  }
}
