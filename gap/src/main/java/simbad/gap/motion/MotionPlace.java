package simbad.gap.motion;

/**
 * A slice of the windows.
 *
 * @param axis what is sliced
 * @param low where the slice begins
 * @param high where it ends
 * @param rows windows in it
 * @param share of the whole gap over half a second
 * @param before mean gap in it, as a share of the mean gap of all windows
 * @param after the same of the diagnosed model
 */
public record MotionPlace(
    String axis, double low, double high, int rows, double share, double before, double after) {}
