package simbad.blindworld.wave;

/**
 * How high something stands, from the sonar's axis.
 *
 * @param bottomM of its lower end, negative below the axis; infinite for no end
 * @param topM of its upper end
 */
public record Upright(double bottomM, double topM) {

  /** Without an end either way. */
  public static final Upright ENDLESS =
      new Upright(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Refuses an upper end that is not above the lower one. */
  public Upright {
    if (!(topM > bottomM)) {
      throw new IllegalArgumentException(
          "height: " + bottomM + " to " + topM + ", expected rising");
    }
  }
}
