package simbad.scene3d;

/** What the window draws besides the world itself, and can leave out. */
public enum Layer {
  /** Where agents have been. */
  TRAILS,
  /** The robots' names. */
  NAMES,
  /** The lines on the floor to which an obstacle is heard. */
  EDGES
}
