package simbad.experiments.export;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import simbad.obstacles.ObstacleType;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.change.LevelAbsorption;
import simbad.sonar.change.LevelAperture;
import simbad.sonar.change.LevelGain;
import simbad.sonar.frame.Pose;
import simbad.sonar.level.Beam;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.EchoPath;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.LevelStrength;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** What a diagnosis says of a sensor that hears by the level law: its law, echoes and beam. */
final class FoldedLevel {
  private final List<Change> heard = new ArrayList<>();
  private Optional<LevelRule> rule = Optional.empty();
  private double gainDb;
  private double absorptionDbPerM;
  private double aperture = 1;
  private boolean isCalibrated;

  /** Takes a change if it is one of the level law's that has a form in C. */
  boolean take(Change change) {
    if (change instanceof LevelRule law) {
      rule = Optional.of(law);
    } else if (change instanceof LevelGain gain) {
      gainDb += gain.gainDb();
      return true;
    } else if (change instanceof LevelAbsorption air) {
      absorptionDbPerM += air.addedDbPerM();
      return true;
    } else if (change instanceof LevelAperture wider) {
      aperture *= wider.factor();
      return true;
    } else if (change instanceof LevelStrength) {
      isCalibrated = true;
    } else if (!(change instanceof EchoPath)) {
      return false;
    }
    heard.add(change);
    return true;
  }

  private LevelRule rule() {
    return rule.orElseThrow(
        () ->
            new IllegalArgumentException("the sensor hears by the level law, which is not in it"));
  }

  /** By how much the beam's axis lies counter-clockwise of the heading, radians. */
  double squintRad() {
    return rule.map(LevelRule::squintRad).orElse(0.0);
  }

  /**
   * Returns the sensor with the ranges that the law was calibrated to: the least is that from which
   * on an echo is more likely than not.
   */
  SonarSpec sensor(SonarSpec changed) {
    double least = rule().minRangeM() - LevelRule.leastRangeStepM(changed) / 2;
    return changed.withRange(Math.max(0, least), rule().maxRangeM());
  }

  /**
   * Returns what is heard of an obstacle.
   *
   * @param model the diagnosis
   * @param geometric changes of the scene
   * @param index of the obstacle in the scene
   * @param type its outline and words
   * @param sensor as it is
   */
  HeaderTarget target(
      FittedModel model, List<Change> geometric, int index, ObstacleType type, SonarSpec sensor) {
    List<Change> all = new ArrayList<>(geometric);
    all.addAll(heard);
    // One pose, to ask the ears that a diagnosis has.
    ReadingRow row = new ReadingRow("folded", "sensor", 0, Pose.of(0, 0, 0), NoEcho.NO_ECHO);
    Geometry geometry = new Geometry(new PingLog(List.of(row)), model.setup(), all);
    LevelEars ears = java.util.Objects.requireNonNull(geometry.ears());
    LevelLaw believed = ears.law();
    LevelLaw law = believed.withAbsorptionDbPerM(believed.absorptionDbPerM() + absorptionDbPerM);
    int bearings =
        isCalibrated
            ? LevelForms.BEARINGS
            : HeaderTarget.PER_BEARING * type.thresholds().table().size();
    return new HeaderTarget(
        type,
        sensor,
        law,
        bearing -> believed.levelDb() + gainDb + ears.strengthDb(index, bearing),
        bearings,
        offAxis -> beamDb(believed.beam(), offAxis),
        Optional.of(new HeaderTarget.Way(rule().rangeScale(), path(ears, index))));
  }

  /** Behind the baffle nothing is heard. */
  private double beamDb(Beam beam, double offAxisRad) {
    return Math.abs(offAxisRad) > Math.PI / 2
        ? Double.NEGATIVE_INFINITY
        : LevelEars.widenedDb(beam, offAxisRad, aperture);
  }

  private static DoubleUnaryOperator path(LevelEars ears, int index) {
    return bearing -> ears.addedM(index, bearing);
  }
}
