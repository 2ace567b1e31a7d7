package simbad.sim;

import javax.media.j3d.BoundingSphere;
import javax.vecmath.Color3f;
import simbad.kernel.geometry.Placement;
import simbad.kernel.scene.Solid;

/** A block-world object made of others, which are placed in its frame. */
public class BlockWorldCompositeObject extends BlockWorldObject {
  BlockWorldCompositeObject() {}

  /** Adds a component; to be called before the object enters a world. */
  protected void addComponent(BlockWorldObject component) {
    addChild(component);
  }

  /** Sets the colour of every component. */
  @Override
  public void setColor(Color3f color) {
    super.setColor(color);
    children().forEach(component -> component.setColor(color));
  }

  @Override
  void addShapesTo(Solid body, Placement bodyFromThis) {
    super.addShapesTo(body, bodyFromThis);
    for (BaseObject component : children()) {
      Placement bodyFromComponent = new Placement();
      bodyFromComponent.compose(bodyFromThis, component.placement());
      component.bodyShapes().forEach(shape -> body.add(shape, bodyFromComponent));
    }
  }

  @Override
  protected void createTransformedBounds() {
    super.createTransformedBounds();
  }

  @Override
  protected boolean intersect(BoundingSphere bounds) {
    return super.intersect(bounds);
  }
}
