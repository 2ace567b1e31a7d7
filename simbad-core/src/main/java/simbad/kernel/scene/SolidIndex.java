package simbad.kernel.scene;

import java.util.ArrayList;
import java.util.List;
import simbad.kernel.geometry.Ray;

/**
 * Solids with the tree that finds them. The tree is brought up to date by the next query after a
 * change: refitted when solids moved, built anew when some came or went or when refitting has made
 * it too loose.
 */
final class SolidIndex {
  /** How many times its cost when built a refitted tree may have. */
  private static final double LOOSENESS = 2;

  private final List<Solid> solids = new ArrayList<>();
  private PartTree tree = new PartTree(new BodyPart[0]);
  private double builtCostM2;
  private boolean changed;
  private boolean moved;
  private int revision;

  void add(Solid solid) {
    solid.enter(this);
    solids.add(solid);
    noteChange();
  }

  void forget(Solid solid) {
    solids.remove(solid);
    noteChange();
  }

  void noteMove() {
    moved = true;
    revision++;
  }

  void noteChange() {
    changed = true;
    revision++;
  }

  /** Returns a number that is another one after any solid came, went or moved. */
  int revision() {
    return revision;
  }

  boolean strike(Ray ray, Solid except) {
    return current().strike(ray, except);
  }

  void gather(Ball ball, Solid except, Neighbourhood near) {
    current().gather(ball, except, near);
  }

  boolean stopsBall(double xM, double yM, double zM, double radiusM) {
    return current().stopsBall(xM, yM, zM, radiusM);
  }

  boolean isFree(double xM, double yM, double zM, double radiusM) {
    return current().isFree(xM, yM, zM, radiusM);
  }

  private PartTree current() {
    if (changed) {
      rebuild();
    } else if (moved) {
      refit();
    }
    return tree;
  }

  private void rebuild() {
    changed = false;
    moved = false;
    tree =
        new PartTree(
            solids.stream()
                .filter(Solid::isPresent)
                .flatMap(solid -> solid.parts().stream())
                .toArray(BodyPart[]::new));
    builtCostM2 = tree.costM2();
  }

  private void refit() {
    moved = false;
    tree.refit();
    if (tree.costM2() > LOOSENESS * builtCostM2) {
      rebuild();
    }
  }
}
