package simbad.sonar.ping;

import simbad.sonar.check.Checks;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;

/**
 * The sensor hears by the level law, not by thresholds: a calibration of the set-up.
 *
 * @param law by which it hears
 * @param squintRad by which its beam's axis lies counter-clockwise of its heading
 * @param missRate share of echoes that are lost whatever their strength, in [0, 1]
 * @param apertureDeviation how far the piston's radius may be off, as a share of it
 * @param squintDeviationRad how far the squint may be off
 * @param minRangeM nearer echoes are not heard, metres
 * @param maxRangeM further ones are not, metres
 * @param rangeScale what is read of a distance, as a share of it: the air is not the one that the
 *     sensor's program assumes
 */
public record LevelRule(
    LevelLaw law,
    double squintRad,
    double missRate,
    double apertureDeviation,
    double squintDeviationRad,
    double minRangeM,
    double maxRangeM,
    double rangeScale)
    implements SensorChange {
  /** A least range is known to no less than this, metres. */
  private static final double LEAST_STEP_M = 0.005;

  /** Checks the figures; NaN is refused. */
  public LevelRule {
    Checks.finite("squintRad", squintRad);
    Checks.share("missRate", missRate);
    Checks.notNegative("apertureDeviation", apertureDeviation);
    Checks.notNegative("squintDeviationRad", squintDeviationRad);
    Checks.notNegative("minRangeM", minRangeM);
    Checks.above("maxRangeM", maxRangeM, minRangeM);
    Checks.positive("rangeScale", rangeScale);
  }

  /** Returns a rule whose beam is known, of a sensor whose range is as believed. */
  public static LevelRule of(SonarSpec sensor) {
    return new LevelRule(
        sensor.levelLaw(), 0, sensor.missRate(), 0, 0, sensor.minRangeM(), sensor.maxRangeM(), 1);
  }

  /**
   * Returns within what a sensor's least range is known: it was read off in steps of the readings,
   * so it lies anywhere in the last one, from the stated least range down.
   *
   * @return metres, at least 5 mm
   */
  public static double leastRangeStepM(SonarSpec sensor) {
    return Math.max(LEAST_STEP_M, sensor.resolutionM());
  }

  /** There is no cone: all before the baffle counts, and the beam says how much. */
  @Override
  public SonarSpec apply(SonarSpec believed) {
    return believed
        .withCone(Math.PI / 2)
        .withScatter(0, missRate, 0)
        .withRange(minRangeM, maxRangeM);
  }
}
