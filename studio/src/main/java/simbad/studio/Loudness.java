package simbad.studio;

import java.util.List;
import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.LevelModel;
import simbad.sonar.model.LevelSight;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.TruePose;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.Outline;

/** How loud an obstacle's echo is, for sensors that hear by a level law. */
@FunctionalInterface
interface Loudness {
  /** Returns what a transducer at a pose hears of the obstacle. */
  Sight at(Pose pose);

  /**
   * An echo.
   *
   * @param excessDb over the receiver's threshold; negative infinity where nothing comes
   * @param nearestM distance to the nearest point of the outline, metres
   * @param sensor whose range counts
   */
  record Sight(double excessDb, double nearestM, SonarSpec sensor) {
    boolean isInRange() {
      return nearestM >= sensor.minRangeM() && nearestM <= sensor.maxRangeM();
    }
  }

  /** Returns the loudness as a sensor has it; empty for one that hears by thresholds. */
  static Optional<Loudness> of(
      SensorKind sensor, SonarSpec spec, ObstacleType type, Placement placement) {
    Obstacle placed =
        new Obstacle(
            type.name(), placement, type.outline(), new TableDetection(type.thresholds().table()));
    Scene scene = new Scene(List.of(placed));
    if (sensor.equals(SensorKind.LEVEL) || sensor.equals(SensorKind.LEVEL_NOISY)) {
      LevelModel model = new LevelModel(spec, scene);
      return Optional.of(
          pose -> {
            LevelSight sight = model.sight(0, pose);
            return new Sight(sight.excessDb(), sight.nearestM(), spec);
          });
    }
    return sensor
        .model()
        .filter(model -> model.changes().stream().anyMatch(LevelRule.class::isInstance))
        .map(model -> fitted(model, scene, type.outline().placed(placement)));
  }

  private static Loudness fitted(FittedModel model, Scene scene, Outline outline) {
    SensingSetup setup = model.setup();
    SensingSetup there = new SensingSetup(setup.sensor(), scene, setup.noEchoM(), setup.details());
    Geometry geometry = new Geometry(1, there, model.changes());
    TruePose from = new TruePose();
    return pose -> {
      from.set(pose.position().xM(), pose.position().zM(), pose.heading().radians());
      geometry.restart();
      geometry.look(0, from);
      double excessDb = geometry.excessDb(0) + geometry.addedDb(model.changes(), 0);
      double nearestM = outline.distanceM(pose.position().xM(), pose.position().zM());
      return new Sight(excessDb, nearestM, geometry.sensor());
    };
  }
}
