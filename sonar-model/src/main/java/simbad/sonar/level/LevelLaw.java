package simbad.sonar.level;

import simbad.sonar.check.Checks;

/**
 * The level law of one sensor in its air: by how many decibels a target's echo exceeds the
 * receiver's threshold, and what follows from that.
 *
 * <p>excess = level + strength + beam - 20 n log10(r / 1 m) - 2 a r - threshold(r), with r the
 * distance to the obstacle's centre. See docs/method/level-model.md. Immutable.
 *
 * @param levelDb of the echo of a target of 0 dB at 1 m in air without loss, over a receiver's
 *     threshold of 0 dB; finite
 * @param spreadingExponent n, of the echo's pressure: 2 for small targets, 1 for a wall; at least 0
 * @param absorptionDbPerM a, one way; at least 0
 * @param beam sender and receiver off the axis
 * @param receiverThresholdDb over the distance in metres
 * @param excessSdDb scatter of the excess from ping to ping; at least 0, 0 for none
 * @param walkM by how much an echo reads long, over its excess in decibels
 * @param noiseM standard deviation of a range, over the excess in decibels; nowhere below 0
 * @param pulseLengthM a pulse's share of a range, c times its duration / 2: echoes that are no
 *     further apart overlap; at least 0
 */
public record LevelLaw(
    double levelDb,
    double spreadingExponent,
    double absorptionDbPerM,
    Beam beam,
    Curve receiverThresholdDb,
    double excessSdDb,
    Curve walkM,
    Curve noiseM,
    double pulseLengthM) {
  /** What is nearer counts as so near: no loss by spreading is endless. */
  static final double LEAST_DISTANCE_M = 0.001;

  /** Checks every figure; the message names the field, the value and what is permitted. */
  public LevelLaw {
    Checks.finite("levelDb", levelDb);
    Checks.notNegative("spreadingExponent", spreadingExponent);
    Checks.notNegative("absorptionDbPerM", absorptionDbPerM);
    Checks.notNegative("excessSdDb", excessSdDb);
    Checks.notNegative("noiseM", noiseM.least());
    Checks.notNegative("pulseLengthM", pulseLengthM);
  }

  /** Returns the same law with another level, decibels. */
  public LevelLaw withLevelDb(double newLevelDb) {
    return new LevelLaw(
        newLevelDb,
        spreadingExponent,
        absorptionDbPerM,
        beam,
        receiverThresholdDb,
        excessSdDb,
        walkM,
        noiseM,
        pulseLengthM);
  }

  /** Returns the same law with another absorption, decibels per metre one way. */
  public LevelLaw withAbsorptionDbPerM(double newAbsorptionDbPerM) {
    return new LevelLaw(
        levelDb,
        spreadingExponent,
        newAbsorptionDbPerM,
        beam,
        receiverThresholdDb,
        excessSdDb,
        walkM,
        noiseM,
        pulseLengthM);
  }

  /** Returns the same law with another beam. */
  public LevelLaw withBeam(Beam newBeam) {
    return new LevelLaw(
        levelDb,
        spreadingExponent,
        absorptionDbPerM,
        newBeam,
        receiverThresholdDb,
        excessSdDb,
        walkM,
        noiseM,
        pulseLengthM);
  }

  /** Returns the same law with another receiver, decibels over metres. */
  public LevelLaw withReceiverThresholdDb(Curve newReceiverThresholdDb) {
    return new LevelLaw(
        levelDb,
        spreadingExponent,
        absorptionDbPerM,
        beam,
        newReceiverThresholdDb,
        excessSdDb,
        walkM,
        noiseM,
        pulseLengthM);
  }

  /**
   * Returns what spreading, absorption and the receiver's threshold take from an echo.
   *
   * @param distanceM to the obstacle's centre, metres; below 1 mm it counts as 1 mm
   * @return decibels
   */
  public double lossDb(double distanceM) {
    double r = Math.max(LEAST_DISTANCE_M, distanceM);
    return 20 * spreadingExponent * Math.log10(r)
        + 2 * absorptionDbPerM * r
        + receiverThresholdDb.at(r);
  }

  /**
   * Returns the excess of a target's echo.
   *
   * @param strengthDb of the target at the sensor's bearing; negative infinity for none
   * @param offAxisRad of its nearest point, either sign
   * @param distanceM to its centre, metres
   * @return decibels over the receiver's threshold; negative infinity where nothing is heard
   */
  public double excessDb(double strengthDb, double offAxisRad, double distanceM) {
    return Decibels.level(axisEnergy(strengthDb, distanceM)) + beam.twoWayDb(offAxisRad);
  }

  /**
   * Returns the ratio of an echo's energy to the threshold's, were the target at the axis of a
   * piston.
   *
   * @param strengthDb of the target at the sensor's bearing; negative infinity for none
   * @param distanceM to its centre, metres
   */
  public double axisEnergy(double strengthDb, double distanceM) {
    return Decibels.energy(levelDb + strengthDb - lossDb(distanceM));
  }

  /**
   * Returns the target strength whose excess is 0 dB on the axis at a distance.
   *
   * @param thresholdM metres; at 0 nothing ever answers
   * @return decibels; negative infinity for a threshold of 0
   */
  public double strengthDb(double thresholdM) {
    return thresholdM > 0 ? lossDb(thresholdM) - levelDb - beam.axisDb() : Double.NEGATIVE_INFINITY;
  }

  /**
   * Returns the greatest target strength that a threshold up to a distance can stand for.
   *
   * @param thresholdM metres, at least 0
   */
  double greatestStrengthDb(double thresholdM) {
    return thresholdM > 0
        ? new LossProfile(this).greatestDb(thresholdM) - levelDb - beam.axisDb()
        : Double.NEGATIVE_INFINITY;
  }

  /**
   * Returns the distance at which a target is first lost by a sensor that looks at it and moves
   * away from it: the least one beyond which its excess is below 0 dB.
   *
   * @param strengthDb of the target; negative infinity for none
   * @param limitM no further than this, metres
   * @return metres, 0 for a target that is not heard anywhere near
   */
  public double firstLossM(double strengthDb, double limitM) {
    return new LossProfile(this).firstAboveM(levelDb + strengthDb + beam.axisDb(), limitM);
  }

  /**
   * Returns the distance from which on a target is nowhere heard, in whatever direction.
   *
   * @param strengthDb of the target; negative infinity for none
   * @param excessDb what counts as heard
   * @param limitM no further than this, metres
   */
  public double reachM(double strengthDb, double excessDb, double limitM) {
    double greatestDb = Decibels.level(beam.greatestEnergy());
    return new LossProfile(this).lastUpToM(levelDb + strengthDb + greatestDb - excessDb, limitM);
  }

  /**
   * Returns what is left of an echo's energy at most, for every cell of the distance.
   *
   * @param cellM size of a cell, metres
   * @param cells how many, the first from 0
   */
  public double[] greatestLeft(double cellM, int cells) {
    LossProfile profile = new LossProfile(this);
    double[] left = new double[cells];
    for (int i = 0; i < cells; i++) {
      left[i] = Decibels.energy(-profile.leastDb(i * cellM, (i + 1) * cellM));
    }
    return left;
  }
}
