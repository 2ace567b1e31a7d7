package simbad.kernel.scene;

import java.util.Arrays;
import java.util.Comparator;
import simbad.kernel.geometry.Extent;
import simbad.kernel.geometry.Ray;

/**
 * A balanced binary tree of extents over parts. Nodes are stored in preorder: what follows a node
 * that is met is its subtree, and {@code skip} leads past the subtree of one that is not, so that a
 * query is one loop without a stack.
 */
final class PartTree {
  private static final int INNER = -1;

  private final BodyPart[] parts;
  private final Extent[] covers;
  private final int[] skip;
  private final int[] leafPart;
  private final Ray local = new Ray();
  private int nodes;

  PartTree(BodyPart[] parts) {
    int most = Math.max(0, 2 * parts.length - 1);
    this.parts = parts;
    covers = new Extent[most];
    skip = new int[most];
    leafPart = new int[most];
    if (parts.length > 0) {
      build(0, parts.length);
      refit();
    }
  }

  private void build(int from, int to) {
    int node = nodes++;
    if (to - from == 1) {
      leafPart[node] = from;
      covers[node] = parts[from].cover();
    } else {
      leafPart[node] = INNER;
      covers[node] = new Extent();
      sortAlongLongestAxis(from, to);
      int middle = (from + to) >>> 1;
      build(from, middle);
      build(middle, to);
    }
    skip[node] = nodes;
  }

  private void sortAlongLongestAxis(int from, int to) {
    Extent all = new Extent();
    for (int i = from; i < to; i++) {
      Extent e = parts[i].extent();
      all.include(e.minX() + e.maxX(), e.minY() + e.maxY(), e.minZ() + e.maxZ());
    }
    double x = all.maxX() - all.minX();
    double y = all.maxY() - all.minY();
    double z = all.maxZ() - all.minZ();
    Comparator<BodyPart> order =
        Comparator.comparingDouble(p -> p.extent().minX() + p.extent().maxX());
    if (z > x && z >= y) {
      order = Comparator.comparingDouble(p -> p.extent().minZ() + p.extent().maxZ());
    } else if (y > x) {
      order = Comparator.comparingDouble(p -> p.extent().minY() + p.extent().maxY());
    }
    Arrays.sort(parts, from, to, order);
  }

  /** Fits the extents to where the parts are now; children come after their parents. */
  void refit() {
    for (int node = nodes - 1; node >= 0; node--) {
      if (leafPart[node] == INNER) {
        covers[node].clear();
        covers[node].include(covers[node + 1]);
        covers[node].include(covers[skip[node + 1]]);
      } else {
        parts[leafPart[node]].solid().refresh();
      }
    }
  }

  /** Returns the summed surface of all nodes: what a query costs, but for a factor. */
  double costM2() {
    double sum = 0;
    for (int node = 0; node < nodes; node++) {
      sum += covers[node].halfSurfaceM2();
    }
    return sum;
  }

  boolean strike(Ray ray, Solid except) {
    boolean struck = false;
    int node = 0;
    while (node < nodes) {
      if (covers[node].isReachedBy(ray)) {
        struck |= leafPart[node] != INNER && strike(ray, parts[leafPart[node]], except);
        node++;
      } else {
        node = skip[node];
      }
    }
    return struck;
  }

  private boolean strike(Ray ray, BodyPart part, Solid except) {
    return part.solid() != except && part.strike(ray, local);
  }

  /** Adds the parts that a ball may touch, but for those of a solid. */
  void gather(Ball ball, Solid except, Neighbourhood near) {
    int node = 0;
    while (node < nodes) {
      if (!covers[node].touchesBall(ball.xM(), ball.yM(), ball.zM(), ball.radiusM())) {
        node = skip[node];
      } else {
        if (leafPart[node] != INNER && parts[leafPart[node]].solid() != except) {
          near.add(parts[leafPart[node]]);
        }
        node++;
      }
    }
  }

  /** Returns true if no part may touch a ball, traversable or not. */
  boolean isFree(double xM, double yM, double zM, double radiusM) {
    int node = 0;
    while (node < nodes) {
      if (!covers[node].touchesBall(xM, yM, zM, radiusM)) {
        node = skip[node];
      } else if (leafPart[node] != INNER) {
        return false;
      } else {
        node++;
      }
    }
    return true;
  }

  boolean stopsBall(double xM, double yM, double zM, double radiusM) {
    int node = 0;
    while (node < nodes) {
      if (!covers[node].touchesBall(xM, yM, zM, radiusM)) {
        node = skip[node];
      } else if (leafPart[node] != INNER
          && parts[leafPart[node]].solid().stopsBall(xM, yM, zM, radiusM)) {
        return true;
      } else {
        node++;
      }
    }
    return false;
  }
}
