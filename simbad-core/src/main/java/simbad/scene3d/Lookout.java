package simbad.scene3d;

import javax.media.j3d.Transform3D;
import javax.vecmath.Matrix3d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

/** The places from which the world can be watched. */
public enum Lookout {
  /** High above the middle of the world, -z up. */
  TOP(false, false, 1 / 2.4, 1 / 2.4) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, 1.2 * sizes.worldM());
    }
  },
  /** From the east, half way down. */
  EAST(false, false, Math.sqrt(2) / 3, 1 / 3.0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(sizes.worldM(), sizes.worldM(), 0), new Point3d(), new Vector3d(-1, 0, 0));
    }
  },
  /** Behind an agent, looking where it goes. */
  BEHIND(true, true, 0, 0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(-8 * sizes.radiusM(), 3 * sizes.heightM(), 0),
          new Point3d(2 * sizes.radiusM(), 0, 0),
          new Vector3d(0, 1, 0));
    }
  },
  /** Far above an agent. */
  ABOVE(true, false, 0, 0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, 0.8 * sizes.worldM());
    }
  },
  /** Above an agent, the nearer the lower it is. */
  ABOVE_NEAR(true, false, 0, 0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      above(viewpoint, Math.max(LEAST_NEAR_M, sizes.heightM() * sizes.worldM() * 0.5));
    }
  },
  /** Beside an agent, on its right as long as it heads along +x. */
  SIDE(true, false, 0, 0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      viewpoint.look(
          new Point3d(0, 2 * sizes.heightM(), 10 * sizes.radiusM()),
          new Point3d(),
          new Vector3d(0, 1, 0));
    }
  },
  /**
   * Outside of an agent, looking over it towards the middle of the world, where what it goes round
   * stands.
   */
  INWARDS(true, true, 0, 0) {
    @Override
    public void place(Viewpoint viewpoint, Sizes sizes) {
      double h = sizes.heightM();
      viewpoint.look(new Point3d(-3.5 * h, 7.5 * h, 0), new Point3d(2.2 * h, 0, 0), UP);
    }

    @Override
    double anchorTurnRad(Transform3D worldFromAgent) {
      Vector3d place = new Vector3d();
      worldFromAgent.get(place);
      return Math.atan2(place.z, 0.0 - place.x);
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

  private static final Vector3d UP = new Vector3d(0, 1, 0);
  private static final double LEAST_NEAR_M = 0.2;

  /** Half of Java 3D's own field of view, across the window. */
  private static final double USUAL = Math.tan(Math.toRadians(45 / 2.0));

  /** For walls of a metre round the floor of a small world: they are nearer to the eye. */
  private static final double MARGIN = 1.12;

  private final boolean follows;
  private final boolean turns;
  private final double across;
  private final double upwards;

  /**
   * Creates a place.
   *
   * @param across tangent of the angle from the middle of the view to the side of the floor where
   *     it appears widest, 0 where the floor need not be in the view
   * @param upwards the same for its upper or lower end
   */
  Lookout(boolean follows, boolean turns, double across, double upwards) {
    this.follows = follows;
    this.turns = turns;
    this.across = across;
    this.upwards = upwards;
  }

  /**
   * Returns the field of view across a window: 45 degrees, or as much more as shows the whole
   * floor.
   *
   * @param width of the window, above 0
   * @param height of the window in the same unit, above 0
   */
  public double fieldOfViewRad(double width, double height) {
    double needed = MARGIN * Math.max(across, upwards * width / height);
    return 2 * Math.atan(Math.max(USUAL, needed));
  }

  /** Returns true if the eye moves with an agent. */
  public boolean follows() {
    return follows;
  }

  /** Returns true if the eye also turns, with the agent's heading or with its place. */
  public boolean turns() {
    return turns;
  }

  /**
   * Returns how the frame of the eye's place is turned about the vertical, radians.
   *
   * @param worldFromAgent where the agent is that the eye follows
   */
  double anchorTurnRad(Transform3D worldFromAgent) {
    if (!turns) {
      return 0;
    }
    Matrix3d turn = new Matrix3d();
    worldFromAgent.get(turn);
    return Math.atan2(turn.m02, turn.m00);
  }

  /** Puts the eye at this place, relative to the viewpoint's anchor. */
  public abstract void place(Viewpoint viewpoint, Sizes sizes);

  private static void above(Viewpoint viewpoint, double distanceM) {
    viewpoint.look(new Point3d(0, distanceM, 0), new Point3d(), new Vector3d(0, 0, -1));
  }
}
