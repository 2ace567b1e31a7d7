package simbad.scene3d;

/** What a legend explains: what the window draws and no real room has. */
public enum Sign {
  /** A robot; its nose shows ahead. */
  ROBOT,
  /** A range sensor that hears nothing. */
  SILENT,
  /** A range sensor with an echo. */
  ECHO,
  /** A detection shadow. */
  SHADOW,
  /** The edge of a detection shadow. */
  EDGE,
  /** Where an agent has been. */
  TRAIL,
  /** The world's axes at the origin. */
  AXES
}
