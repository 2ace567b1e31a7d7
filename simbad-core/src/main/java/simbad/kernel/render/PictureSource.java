package simbad.kernel.render;

import simbad.kernel.geometry.Placement;

/**
 * Takes pictures of one stage. A picture shows the stage as it is during the call. Not safe for use
 * by several threads.
 */
public interface PictureSource {
  /** How wide an eye sees: the angle between the left and the right edge of a picture, radians. */
  double FIELD_OF_VIEW_RAD = Math.toRadians(45);

  /**
   * What is nearer to the eye than this, metres, along its axis, is not seen: 0.1 m before a robot
   * of the usual size, whose own rim and nose are not in its camera's way.
   */
  double NEAR_M = 0.4;

  /**
   * Takes a picture.
   *
   * @param worldFromEye where the eye is: it looks along its x axis, y is up
   * @param picture is overwritten
   */
  void take(Placement worldFromEye, Picture picture);

  /** Frees what the source holds; it takes no more pictures. */
  default void dispose() {
    // Most hold nothing but memory.
  }
}
