package simbad.scene3d;

import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

/** The places from which the world can be watched. */
public enum Lookout {
  /** High above the middle of the world, -z up. */
  TOP(false, false) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, 1.2 * sizes.worldM());
    }
  },
  /** From the east, half way down. */
  EAST(false, false) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(sizes.worldM(), sizes.worldM(), 0), new Point3d(), new Vector3d(-1, 0, 0));
    }
  },
  /** Behind an agent, looking where it goes. */
  BEHIND(true, true) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(-8 * sizes.radiusM(), 3 * sizes.heightM(), 0),
          new Point3d(2 * sizes.radiusM(), 0, 0),
          new Vector3d(0, 1, 0));
    }
  },
  /** Far above an agent. */
  ABOVE(true, false) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, 0.8 * sizes.worldM());
    }
  },
  /** Above an agent, the nearer the lower it is. */
  ABOVE_NEAR(true, false) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, Math.max(LEAST_NEAR_M, sizes.heightM() * sizes.worldM() * 0.5));
    }
  },
  /** Beside an agent, on its right as long as it heads along +x. */
  SIDE(true, false) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(0, 2 * sizes.heightM(), 10 * sizes.radiusM()),
          new Point3d(),
          new Vector3d(0, 1, 0));
    }
  };

  /**
   * What the distances go by.
   *
   * @param worldM side of the floor, metres, above 0
   * @param heightM height of the agent that is followed, metres, above 0
   * @param radiusM its radius, metres, above 0
   */
  public record Sizes(double worldM, double heightM, double radiusM) {
    /** Checks the sizes. */
    public Sizes {
      if (!(worldM > 0 && heightM > 0 && radiusM > 0)) {
        throw new IllegalArgumentException(
            "sizes = " + worldM + ", " + heightM + ", " + radiusM + " are not in (0, infinity)");
      }
    }
  }

  private static final double LEAST_NEAR_M = 0.2;

  private final boolean follows;
  private final boolean turns;

  Lookout(boolean follows, boolean turns) {
    this.follows = follows;
    this.turns = turns;
  }

  /** Returns true if the eye moves with an agent. */
  public boolean follows() {
    return follows;
  }

  /** Returns true if the eye also turns with the agent's heading. */
  public boolean turns() {
    return turns;
  }

  /** Puts the eye at this place, relative to the viewpoint's anchor. */
  public abstract void place(Viewpoint viewpoint, Sizes sizes);

  private static void above(Viewpoint viewpoint, double distanceM) {
    viewpoint.look(new Point3d(0, distanceM, 0), new Point3d(), new Vector3d(0, 0, -1));
  }
}
