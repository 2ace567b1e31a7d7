package simbad.scene3d;

import java.util.EnumSet;
import java.util.Set;
import javax.media.j3d.Node;

/**
 * A part of a scene that may look different from frame to frame.
 *
 * <p>{@link #capture()} is called while no step is under way and only copies; {@link #show()} is
 * called afterwards, while steps go on, and hands the copies to Java 3D.
 */
public interface Animated {
  /** Returns the node that is drawn; always the same. */
  Node node();

  /** Copies what changes. */
  void capture();

  /** Draws what was copied. */
  void show();

  /** Takes on how the scene shall be shown from now on; called between captures. */
  default void adopt(Look look) {
    // Most parts look the same in every light.
  }

  /** Returns what of it a legend explains; most parts need none. */
  default Set<Sign> signs() {
    return EnumSet.noneOf(Sign.class);
  }
}
