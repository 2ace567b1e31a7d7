package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * The physics of a set-up apart from any effect: what the scene says, or a little beside it.
 *
 * @param edgeWidthM the scale of the logistic fall at the threshold
 * @param missRate the share of echoes that are missed near by
 * @param rangeNoiseM standard deviation of most ranges
 * @param tailShare the share of ranges that scatter more
 * @param tailScale how many times more those scatter
 * @param persistence the chance that a ping repeats the chance events of the ping before
 * @param ripple the thresholds' deviation by bearing
 * @param beamEdgeRad the last part of the cone, over which the threshold falls by a tenth
 * @param wideningRad how much the cone is wider than believed
 */
public record Setup(
    double edgeWidthM,
    double missRate,
    double rangeNoiseM,
    double tailShare,
    double tailScale,
    double persistence,
    Ripple ripple,
    double beamEdgeRad,
    double wideningRad) {
  /** Refuses what is no such thing. */
  public Setup {
    Checks.notNegative("width of the edge", edgeWidthM);
    Checks.share("miss rate", missRate);
    Checks.notNegative("noise of ranges", rangeNoiseM);
    Checks.share("share of tails", tailShare);
    Checks.notNegative("scale of tails", tailScale);
    Checks.share("persistence", persistence);
    Checks.notNegative("edge of the beam", beamEdgeRad);
    Checks.finite("widening", wideningRad);
  }

  private static final double RIM_LOSS = 0.1;

  /** A smooth deviation of thresholds by bearing: a sum of two waves. */
  public record Ripple(double share, int waves, double phaseRad) {
    /** Refuses what is no such thing. */
    public Ripple {
      Checks.notNegative("ripple", share);
      Checks.finite("phase", phaseRad);
    }

    /** By which factor a threshold at this bearing differs. */
    public double factor(int body, double bearingRad) {
      double first = StrictMath.sin(waves * bearingRad + phaseRad + body);
      double second = StrictMath.sin((waves + 3) * bearingRad - 2 * phaseRad + 2 * body);
      return 1 + share * (0.7 * first + 0.5 * second);
    }
  }

  /** The set-up as the scene says. */
  public static Setup nominal(Sensor sensor) {
    return new Setup(
        sensor.edgeWidthM(),
        sensor.missRate(),
        sensor.rangeNoiseM(),
        0,
        1,
        0,
        new Ripple(0, 1, 0),
        0,
        0);
  }

  /** The threshold of an obstacle in this set-up, in metres. */
  double thresholdM(Sight sight, double halfAngleRad) {
    double threshold =
        ripple.share == 0
            ? sight.thresholdM()
            : sight.thresholdM() * ripple.factor(sight.body(), sight.bearingRad());
    double fromRim = halfAngleRad - Math.abs(sight.offAxisRad());
    return beamEdgeRad == 0 || fromRim >= beamEdgeRad
        ? threshold
        : threshold * (1 - RIM_LOSS * (1 - fromRim / beamEdgeRad));
  }
}
