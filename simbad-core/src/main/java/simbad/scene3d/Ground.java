package simbad.scene3d;

import java.util.List;
import javax.media.j3d.Background;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.LineArray;
import javax.media.j3d.Shape3D;
import javax.vecmath.Point3d;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;

/** The floor, the grid on it and the background. */
final class Ground implements Animated {
  private static final float GRID_OPACITY = 0.12f;

  /** So far above the floor that both can be told apart from afar. */
  private static final double GRID_LEVEL_M = 0.002;

  /** More lines would be a grey mash. */
  private static final int MOST_GRID_LINES = 100;

  private final double sideM;
  private final Backdrop backdrop;
  private final BranchGroup group = new BranchGroup();
  private final Background background;
  private final Ink grid;
  private final Figure floor;
  private final Visual floorVisual = new Visual(new Placement(), this::floorFacets);
  private Look look = Look.LIGHT;

  Ground(double sideM, Backdrop backdrop) {
    this.sideM = sideM;
    this.backdrop = backdrop;
    background = Illumination.background(backdrop.background(look));
    grid = new Ink(gridPalette().grid(), GRID_OPACITY, 1);
    floor = new Figure(floorVisual);
    group.addChild(background);
    group.addChild(floor.node());
    group.addChild(new Shape3D(gridLines(sideM), grid.appearance()));
  }

  /** One face, so that the light falls on its corners alone, as in the original. */
  private List<Facets> floorFacets() {
    return List.of(Facets.lit(BoxShape.ofSides(sideM, 0, sideM), backdrop.floor(look)));
  }

  /** A faint grid of metres, by which one sees where the floor ends. */
  private static LineArray gridLines(double sideM) {
    int count = Math.max(2, Math.min(MOST_GRID_LINES, (int) Math.round(sideM) + 1));
    LineArray lines = new LineArray(4 * count, GeometryArray.COORDINATES);
    double half = sideM / 2;
    for (int i = 0; i < count; i++) {
      double at = -half + sideM * i / (count - 1);
      lines.setCoordinate(4 * i, new Point3d(at, GRID_LEVEL_M, -half));
      lines.setCoordinate(4 * i + 1, new Point3d(at, GRID_LEVEL_M, half));
      lines.setCoordinate(4 * i + 2, new Point3d(-half, GRID_LEVEL_M, at));
      lines.setCoordinate(4 * i + 3, new Point3d(half, GRID_LEVEL_M, at));
    }
    return lines;
  }

  private Palette gridPalette() {
    return Palette.of(backdrop.onFloor(look));
  }

  @Override
  public BranchGroup node() {
    return group;
  }

  @Override
  public void capture() {
    floor.capture();
  }

  @Override
  public void show() {
    floor.show();
  }

  @Override
  public void adopt(Look newLook) {
    look = newLook;
    background.setColor(Facet3D.color(backdrop.background(look)));
    grid.set(gridPalette().grid());
    floorVisual.lookChanged();
  }
}
