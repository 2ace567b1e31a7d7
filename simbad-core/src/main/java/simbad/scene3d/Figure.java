package simbad.scene3d;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Group;
import javax.media.j3d.Node;
import javax.media.j3d.Switch;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.Placement;

/**
 * One object in the scene: the triangles of a visual, and nodes that only the window shows, in the
 * object's own frame. It follows the visual. Figures may hold others.
 */
public final class Figure implements Animated {
  private final Visual visual;
  private final BranchGroup branch = new BranchGroup();
  private final TransformGroup pose = new TransformGroup();
  private final Switch visible = new Switch(Switch.CHILD_ALL);
  private final List<Animated> parts = new CopyOnWriteArrayList<>();
  private final double[] captured = new double[16];
  private final double[] shown = new double[16];
  private BranchGroup body = new BranchGroup();
  private List<Facets> facets = List.of();
  private List<Facets> facetsShown = List.of();
  private boolean presentCaptured = true;
  private boolean presentShown = true;

  /**
   * Creates a figure of a visual without the visual's parts.
   *
   * @param visual what the object looks like and where it is; followed, not copied
   */
  public Figure(Visual visual) {
    this.visual = visual;
    branch.setCapability(BranchGroup.ALLOW_DETACH);
    pose.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
    visible.setCapability(Switch.ALLOW_SWITCH_WRITE);
    visible.setCapability(Group.ALLOW_CHILDREN_EXTEND);
    visible.setCapability(Group.ALLOW_CHILDREN_WRITE);
    branch.addChild(pose);
    pose.addChild(visible);
    visible.addChild(body);
    body.setCapability(BranchGroup.ALLOW_DETACH);
    capture();
    show();
  }

  /** Creates a figure of a visual with all of its parts. */
  public static Figure whole(Visual visual) {
    Figure figure = new Figure(visual);
    visual.parts().forEach(part -> figure.add(whole(part)));
    return figure;
  }

  /** Adds a node in the object's frame. */
  public void add(Node node) {
    visible.addChild(node);
  }

  /** Adds an attachment in the object's frame; it is taken out of the scene that had it before. */
  public void add(Attachment attachment) {
    visible.addChild(attachment.takenOut());
  }

  /** Adds a part that may change. */
  public void add(Animated part) {
    add(part.node());
    parts.add(part);
  }

  @Override
  public BranchGroup node() {
    return branch;
  }

  @Override
  public void capture() {
    presentCaptured = visual.isPresent();
    facets = visual.facets();
    capture(visual.frameFromVisual());
    parts.forEach(Animated::capture);
  }

  private void capture(Placement placement) {
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        captured[row * 4 + column] = placement.rotation(row, column);
      }
    }
    captured[3] = placement.xM();
    captured[7] = placement.yM();
    captured[11] = placement.zM();
    captured[15] = 1;
  }

  @Override
  public void show() {
    if (presentCaptured != presentShown) {
      presentShown = presentCaptured;
      visible.setWhichChild(presentShown ? Switch.CHILD_ALL : Switch.CHILD_NONE);
    }
    if (!facets.equals(facetsShown)) {
      facetsShown = facets;
      showBody();
    }
    if (!Arrays.equals(captured, shown)) {
      System.arraycopy(captured, 0, shown, 0, shown.length);
      pose.setTransform(new Transform3D(shown));
    }
    parts.forEach(Animated::show);
  }

  private void showBody() {
    BranchGroup changed = new BranchGroup();
    changed.setCapability(BranchGroup.ALLOW_DETACH);
    facetsShown.forEach(facet -> changed.addChild(Facet3D.of(facet)));
    body.detach();
    body = changed;
    visible.addChild(body);
  }

  @Override
  public void adopt(Look look) {
    parts.forEach(part -> part.adopt(look));
  }

  @Override
  public Set<Sign> signs() {
    Set<Sign> all = EnumSet.noneOf(Sign.class);
    parts.forEach(part -> all.addAll(part.signs()));
    return all;
  }

  /** Returns true if the object was to be seen when it was last captured. */
  boolean isPresent() {
    return presentCaptured;
  }

  /** Writes where the object was in its frame when it was last captured. */
  public void get(Transform3D frameFromObject) {
    frameFromObject.set(captured);
  }
}
