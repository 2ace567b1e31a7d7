package simbad.sonar.scene;

import simbad.sonar.check.Checks;
import simbad.sonar.level.LevelLaw;

/**
 * The figures of a sonar, as the simulator believes them.
 *
 * @param name of the sensor, free text
 * @param coneHalfAngleRad how far off its heading it hears; in (0, pi]
 * @param minRangeM nearer echoes are not heard; at least 0
 * @param maxRangeM further echoes are not heard; above minRangeM, finite
 * @param mountHeightM of the transducer over the floor; at least 0
 * @param assumedSoundSpeedMPerS that turns its times into ranges; positive
 * @param resolutionM step of the ranges reported; 0 for none
 * @param rangeNoiseM standard deviation of a range; at least 0
 * @param missRate share of echoes that are lost whatever the geometry; in [0, 1]
 * @param edgeWidthM softness of the threshold: the distance over which the chance of an echo falls
 *     from 1/2 to 1/(1+e); 0 for a step
 * @param updatePeriodS time from ping to ping; positive
 * @param law by which it is believed to hear
 */
public record SonarSpec(
    String name,
    double coneHalfAngleRad,
    double minRangeM,
    double maxRangeM,
    double mountHeightM,
    double assumedSoundSpeedMPerS,
    double resolutionM,
    double rangeNoiseM,
    double missRate,
    double edgeWidthM,
    double updatePeriodS,
    SensorLaw law) {

  /** Checks every figure; the message names the field, the value and what is permitted. */
  public SonarSpec {
    require(
        coneHalfAngleRad > 0 && coneHalfAngleRad <= Math.PI,
        "coneHalfAngleRad",
        coneHalfAngleRad,
        "(0, pi]");
    Checks.notNegative("minRangeM", minRangeM);
    require(
        maxRangeM > minRangeM && maxRangeM < Double.POSITIVE_INFINITY,
        "maxRangeM",
        maxRangeM,
        "(minRangeM = " + minRangeM + ", infinity)");
    Checks.notNegative("mountHeightM", mountHeightM);
    Checks.positive("assumedSoundSpeedMPerS", assumedSoundSpeedMPerS);
    Checks.notNegative("resolutionM", resolutionM);
    Checks.notNegative("rangeNoiseM", rangeNoiseM);
    Checks.share("missRate", missRate);
    Checks.notNegative("edgeWidthM", edgeWidthM);
    Checks.positive("updatePeriodS", updatePeriodS);
  }

  /** Creates the figures of a sensor that says nothing of its law. */
  public SonarSpec(
      String name,
      double coneHalfAngleRad,
      double minRangeM,
      double maxRangeM,
      double mountHeightM,
      double assumedSoundSpeedMPerS,
      double resolutionM,
      double rangeNoiseM,
      double missRate,
      double edgeWidthM,
      double updatePeriodS) {
    this(
        name,
        coneHalfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        resolutionM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        SensorLaw.UNSTATED);
  }

  /**
   * Returns the level law by which it hears; what is not stated follows from its cone, its noise
   * and the defaults of its kind.
   */
  public LevelLaw levelLaw() {
    return law.level().law(coneHalfAngleRad, rangeNoiseM);
  }

  /** Returns the same sensor with another law. */
  public SonarSpec withLaw(SensorLaw newLaw) {
    return new SonarSpec(
        name,
        coneHalfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        resolutionM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        newLaw);
  }

  /** Returns the same sensor with another cone half angle, radians in (0, pi]. */
  public SonarSpec withCone(double halfAngleRad) {
    return new SonarSpec(
        name,
        halfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        resolutionM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        law);
  }

  /**
   * Returns the same sensor with other limits of what it hears.
   *
   * @param leastM nearer echoes are not heard, at least 0
   * @param mostM further ones are not, above that, finite
   */
  public SonarSpec withRange(double leastM, double mostM) {
    return new SonarSpec(
        name,
        coneHalfAngleRad,
        leastM,
        mostM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        resolutionM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        law);
  }

  /**
   * Returns the same sensor with another scatter.
   *
   * @param noiseM standard deviation of a range, at least 0
   * @param misses share of echoes that are lost, in [0, 1]
   * @param edgeM softness of the threshold, at least 0
   */
  public SonarSpec withScatter(double noiseM, double misses, double edgeM) {
    return new SonarSpec(
        name,
        coneHalfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        resolutionM,
        noiseM,
        misses,
        edgeM,
        updatePeriodS,
        law);
  }

  /** Returns the same sensor that computes with another speed of sound, metres per second. */
  public SonarSpec withSoundSpeed(double metresPerSecond) {
    return new SonarSpec(
        name,
        coneHalfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        metresPerSecond,
        resolutionM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        law);
  }

  /** Returns the same sensor with another step of the ranges reported, metres; 0 for none. */
  public SonarSpec withResolution(double stepM) {
    return new SonarSpec(
        name,
        coneHalfAngleRad,
        minRangeM,
        maxRangeM,
        mountHeightM,
        assumedSoundSpeedMPerS,
        stepM,
        rangeNoiseM,
        missRate,
        edgeWidthM,
        updatePeriodS,
        law);
  }

  private static void require(boolean holds, String field, double value, String permitted) {
    if (!holds) {
      throw new IllegalArgumentException(field + " = " + value + " is not in " + permitted);
    }
  }
}
