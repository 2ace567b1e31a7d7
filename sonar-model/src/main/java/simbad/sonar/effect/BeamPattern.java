package simbad.sonar.effect;

/**
 * Sensitivity tapers off the axis: the threshold is shorter there.
 *
 * @param widthRad angle that sets how fast it tapers, positive; infinity is neutral
 * @param power shape of the taper, positive
 * @param law kind of the taper
 */
public record BeamPattern(double widthRad, double power, Law law) implements ThresholdChange {
  /** How a threshold shrinks at an angle, u being the angle over the width. */
  public enum Law {
    /** exp(-u^(2 power)). */
    BELL,
    /** cos(pi/2 u)^power; 0 beyond the width. */
    COSINE,
    /** (1 - u)^power; 0 beyond the width. */
    RAMP
  }

  @Override
  public double factor(Geometry geometry, int line) {
    if (widthRad == Double.POSITIVE_INFINITY) {
      return 1;
    }
    double angle = Math.min(Math.abs(geometry.offAxisRad(line)), geometry.coneHalfAngleRad());
    double u = angle / widthRad;
    return switch (law) {
      case BELL -> Math.exp(-Math.pow(u, 2 * power));
      case COSINE -> u < 1 ? Math.pow(Math.cos(Math.PI / 2 * u), power) : 0;
      case RAMP -> u < 1 ? Math.pow(1 - u, power) : 0;
    };
  }
}
