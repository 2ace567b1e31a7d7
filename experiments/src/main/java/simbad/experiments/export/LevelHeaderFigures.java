package simbad.experiments.export;

import java.util.Arrays;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.LevelLaw;

/** The figures of the level model in whole numbers: hundredths of a decibel, halves of a mm. */
@SuppressWarnings("ArrayRecordComponent") // read only
record LevelHeaderFigures(
    int[] strengthCdb,
    int[] beamCdb,
    int[] lossCdb,
    int[] walkHalf,
    int[] wayHalf,
    int scale,
    int[] cornerHalfMm,
    int leastHalves,
    int mostHalves) {
  /** What is fainter is nowhere heard, and fits. */
  private static final double LEAST_DB = -200;

  private static final double MOST_DB = 300;

  private static final int BEAMS = 258;
  private static final double BEAM_STEP_RAD = Math.PI / 256;
  private static final double LOSS_STEP_M = 0.032;
  private static final int WALKS = 18;
  private static final double WALK_STEP_DB = 2.56;

  static LevelHeaderFigures of(HeaderTarget target) {
    HeaderFigures.requireFit(target.type().outline(), target.sensor());
    LevelLaw law = target.law();
    int[] strength = new int[target.bearings() + 1];
    Arrays.setAll(strength, i -> cdb(target.echoDb().applyAsDouble(bearingRad(i, strength))));
    int[] beam = new int[BEAMS];
    Arrays.setAll(beam, i -> cdb(target.beamDb().applyAsDouble(offAxisRad(i))));
    double farthestM = target.sensor().maxRangeM() + target.type().outline().reachM(0, 0);
    int[] loss = new int[(int) Math.ceil(farthestM / LOSS_STEP_M) + 2];
    Arrays.setAll(loss, i -> cdb(law.lossDb(i * LOSS_STEP_M)));
    int[] walk = new int[WALKS];
    Arrays.setAll(walk, i -> HeaderFigures.halves(law.walkM().at(i * WALK_STEP_DB)));
    int[] way = new int[target.calibrated().isPresent() ? strength.length : 0];
    target
        .calibrated()
        .map(HeaderTarget.Way::addedM)
        .ifPresent(
            added ->
                Arrays.setAll(
                    way, i -> HeaderFigures.halves(added.applyAsDouble(bearingRad(i, way)))));
    double scale = target.calibrated().map(HeaderTarget.Way::scale).orElse(1.0);
    return new LevelHeaderFigures(
        strength,
        beam,
        loss,
        walk,
        way,
        (int) Math.rint(IntegerSonar.ONE * scale),
        HeaderFigures.corners(target.type().outline()),
        HeaderFigures.halves(target.sensor().minRangeM()),
        HeaderFigures.halves(target.sensor().maxRangeM()));
  }

  /** Bearings are even; the last is the first again. */
  private static double bearingRad(int index, int[] table) {
    int steps = table.length - 1;
    return index % steps * Angles.TURN_RAD / steps;
  }

  private static double offAxisRad(int index) {
    return Math.min(Math.PI, index * BEAM_STEP_RAD);
  }

  /** Not less than what fits. */
  static double least(double decibels) {
    return Math.max(LEAST_DB, decibels);
  }

  private static int cdb(double decibels) {
    double shown = least(decibels);
    if (!(shown <= MOST_DB)) {
      throw new IllegalArgumentException(
          "a level of " + decibels + " dB, expected at most 300 in a C99 header");
    }
    return (int) Math.rint(100 * shown);
  }
}
