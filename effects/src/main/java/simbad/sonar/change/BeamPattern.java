package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.ThresholdChange;

/**
 * Sensitivity tapers off the axis: the threshold is shorter there.
 *
 * @param widthRad angle that sets how fast it tapers, positive; infinity is neutral
 * @param power shape of the taper, positive
 * @param law kind of the taper
 * @param angle of what it tapers
 */
public record BeamPattern(double widthRad, double power, Law law, Angle angle)
    implements ThresholdChange {
  /** Of what of an obstacle the angle off the axis counts. */
  public enum Angle {
    /** Of its centre. */
    CENTRE,
    /** Of the point that would be read: the nearest of its outline in the cone. */
    NEAREST,
    /** Of the point of its outline that is nearest to the axis. */
    OUTLINE
  }

  /** How a threshold shrinks at an angle, u being the angle over the width. */
  public enum Law {
    /** exp(-u^(2 power)). */
    BELL,
    /** cos(pi/2 u)^power; 0 beyond the width. */
    COSINE,
    /** (1 - u)^power; 0 beyond the width. */
    RAMP
  }

  /** Checks the figures; NaN is refused. */
  public BeamPattern {
    Checks.positiveOrInfinite("widthRad", widthRad);
    Checks.positive("power", power);
  }

  @Override
  public double factor(Geometry geometry, int line) {
    if (widthRad == Double.POSITIVE_INFINITY) {
      return 1;
    }
    double off =
        switch (angle) {
          case CENTRE -> Math.abs(geometry.offAxisRad(line));
          case NEAREST -> Math.abs(geometry.echoOffAxisRad(line));
          case OUTLINE -> geometry.outlineOffAxisRad(line);
        };
    double u = Math.min(off, geometry.coneHalfAngleRad()) / widthRad;
    return switch (law) {
      case BELL -> Math.exp(-Math.pow(u, 2 * power));
      case COSINE -> u < 1 ? Math.pow(Math.cos(Math.PI / 2 * u), power) : 0;
      case RAMP -> u < 1 ? Math.pow(1 - u, power) : 0;
    };
  }
}
