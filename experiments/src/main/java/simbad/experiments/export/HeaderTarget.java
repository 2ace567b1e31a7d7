package simbad.experiments.export;

import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import simbad.obstacles.ObstacleType;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.ThresholdTable;

/**
 * An obstacle as a sensor hears it by the level law: what a header of the level model is made of.
 *
 * @param type its outline and words; its thresholds count only where nothing is calibrated
 * @param sensor its ranges and words
 * @param law of what is lost on the way, and of the walk
 * @param echoDb by bearing in the obstacle's frame, radians: the echo's level at 1 m on the axis of
 *     a piston, were nothing lost; negative infinity for none
 * @param bearings in how many even steps of the bearing whole numbers keep it
 * @param beamDb by the angle off the axis, radians: by how much it is stronger than on the axis
 * @param calibrated what a calibration says of the distance that is read; empty for the model alone
 */
record HeaderTarget(
    ObstacleType type,
    SonarSpec sensor,
    LevelLaw law,
    DoubleUnaryOperator echoDb,
    int bearings,
    DoubleUnaryOperator beamDb,
    Optional<Way> calibrated) {
  /** Between two bearings of a table the strength is no straight line. */
  static final int PER_BEARING = 5;

  /**
   * What is read of the distance to the nearest point, before the walk.
   *
   * @param scale share of it that is read
   * @param addedM by bearing, radians: by how much the echo comes from beyond it, metres
   */
  record Way(double scale, DoubleUnaryOperator addedM) {}

  /**
   * Takes an obstacle with thresholds before a sensor whose law is stated.
   *
   * @throws IllegalArgumentException for a figure that no header can hold; the message names it
   */
  static HeaderTarget of(ObstacleType type, SonarSpec sensor) {
    HeaderFigures.of(type, sensor);
    LevelLaw law = sensor.levelLaw();
    ThresholdTable table = type.thresholds().table();
    return new HeaderTarget(
        type,
        sensor,
        law,
        bearing -> law.levelDb() + law.strengthDb(table.thresholdM(bearing)),
        PER_BEARING * table.size(),
        law.beam()::twoWayDb,
        Optional.empty());
  }
}
