package simbad.scene3d;

import java.util.List;
import javax.media.j3d.Background;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Shape3D;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;

/** The floor, the grid on it and the background. */
final class Ground implements Animated {
  private static final float GRID_OPACITY = 0.12f;

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
    group.addChild(new Shape3D(FloorGrid.lines(sideM), grid.appearance()));
  }

  /** One face, so that the light falls on its corners alone, as in the original. */
  private List<Facets> floorFacets() {
    return List.of(Facets.lit(BoxShape.ofSides(sideM, 0, sideM), backdrop.floor(look)));
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
