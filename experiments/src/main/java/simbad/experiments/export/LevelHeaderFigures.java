package simbad.experiments.export;

import java.util.Arrays;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.ThresholdTable;

/** The figures of the level model in whole numbers: hundredths of a decibel, halves of a mm. */
@SuppressWarnings("ArrayRecordComponent") // read only
record LevelHeaderFigures(
    int[] strengthCdb,
    int[] beamCdb,
    int[] lossCdb,
    int[] walkHalf,
    int[] cornerHalfMm,
    int leastHalves,
    int mostHalves) {
  /** What is fainter is nowhere heard, and fits. */
  private static final double LEAST_DB = -200;

  private static final double MOST_DB = 300;

  /** Between two bearings of a table the strength is no straight line. */
  private static final int PER_BEARING = 5;

  private static final int BEAMS = 258;
  private static final double BEAM_STEP_RAD = Math.PI / 256;
  private static final double LOSS_STEP_M = 0.032;
  private static final int WALKS = 18;
  private static final double WALK_STEP_DB = 2.56;

  static LevelHeaderFigures of(ObstacleType type, SonarSpec sensor) {
    HeaderFigures plain = HeaderFigures.of(type, sensor);
    LevelLaw law = sensor.levelLaw();
    ThresholdTable table = type.thresholds().table();
    int[] strength = new int[PER_BEARING * table.size() + 1];
    Arrays.setAll(
        strength,
        i -> {
          double bearing = i % (strength.length - 1) * Angles.TURN_RAD / (strength.length - 1);
          return cdb(law.levelDb() + law.strengthDb(table.thresholdM(bearing)));
        });
    int[] beam = new int[BEAMS];
    Arrays.setAll(beam, i -> cdb(law.beam().twoWayDb(Math.min(Math.PI, i * BEAM_STEP_RAD))));
    double farthestM = sensor.maxRangeM() + type.outline().reachM(0, 0);
    int[] loss = new int[(int) Math.ceil(farthestM / LOSS_STEP_M) + 2];
    Arrays.setAll(loss, i -> cdb(law.lossDb(i * LOSS_STEP_M)));
    int[] walk = new int[WALKS];
    Arrays.setAll(walk, i -> (int) Math.rint(2000 * law.walkM().at(i * WALK_STEP_DB)));
    return new LevelHeaderFigures(
        strength, beam, loss, walk, plain.cornerHalfMm(), plain.leastHalves(), plain.mostHalves());
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
