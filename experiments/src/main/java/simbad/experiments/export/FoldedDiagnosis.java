package simbad.experiments.export;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.obstacles.ObstacleType;
import simbad.sonar.change.AirTemperature;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.change.BeamPattern;
import simbad.sonar.change.CoarseResolution;
import simbad.sonar.change.DeadZone;
import simbad.sonar.change.Dropout;
import simbad.sonar.change.EarlyTimeout;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.change.NearClamp;
import simbad.sonar.change.NearLimit;
import simbad.sonar.change.NoEchoCode;
import simbad.sonar.change.NoiseTails;
import simbad.sonar.change.RangeNoise;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.change.ReadingTimeout;
import simbad.sonar.change.SensorScatter;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.change.StaleReading;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.format.TableDocument;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.NearEcho;
import simbad.sonar.ping.NearRange;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.RangeChange;
import simbad.sonar.ping.SceneChange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.ping.SensorChange;
import simbad.sonar.ping.ThresholdChange;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.ThresholdTable;

/**
 * A diagnosis before one obstacle, its effects folded into the figures of a header: what scatters
 * is left out, and where echoes come from near by; what is more likely than not counts as certain.
 * Effects without such a form are refused by name.
 */
public final class FoldedDiagnosis {
  /** A threshold that is the same all round becomes a polygon. */
  private static final int BEARINGS = 180;

  /** Of sound in a rule: an effect that is at work less often than not has no part in it. */
  private static final double HALF = 0.5;

  private final FittedModel model;
  private final int index;
  private final Obstacle believed;
  private final boolean isLevel;
  private final FoldedLevel levels = new FoldedLevel();
  private final List<Change> geometric = new ArrayList<>();
  private final List<String> leftOut = new ArrayList<>();
  private final List<String> nearFields = new ArrayList<>();
  private final List<String> folded = new ArrayList<>();
  private RangeFigures ranges = RangeFigures.AS_IT_IS;
  private double turnRad;
  private double leastM;
  private double mostM = Double.POSITIVE_INFINITY;
  private Optional<Hysteresis> hysteresis = Optional.empty();
  private int repeats;

  /**
   * Folds a diagnosis.
   *
   * @param model what was fitted
   * @param label of the obstacle; may be empty where there is one only
   * @throws IllegalArgumentException naming an effect that has no form in C, or no such obstacle
   */
  public FoldedDiagnosis(FittedModel model, String label) {
    this.model = model;
    Scene scene = model.setup().scene();
    List<String> labels = Scenes.labels(scene);
    index = label.isEmpty() && labels.size() == 1 ? 0 : labels.indexOf(label);
    if (index < 0) {
      throw new IllegalArgumentException(
          "obstacle = "
              + (label.isEmpty()
                  ? "is missing; expected one of "
                  : "'" + label + "' is not one of ")
              + String.join(", ", labels));
    }
    believed = scene.obstacles().get(index);
    isLevel = model.changes().stream().anyMatch(LevelRule.class::isInstance);
    Stream.concat(model.calibration().stream(), model.effects().stream())
        .sorted(Comparator.comparingInt(FoldedDiagnosis::order))
        .forEach(this::take);
  }

  private static final String NO_FORM = "that cannot be written in C";

  /** Tells whether the sensor hears by the level law: a {@link LevelHeader} holds it. */
  public boolean isLevel() {
    return isLevel;
  }

  /** Ranges are scaled before they are shifted. */
  private static int order(FittedForm fitted) {
    return fitted.change() instanceof RangeChange range ? range.order() : 0;
  }

  private void take(FittedForm fitted) {
    Change change = fitted.change();
    boolean known =
        (isLevel && levels.take(change))
            || takeGeometric(change)
            || takeRange(change)
            || takeMemory(change);
    if (known) {
      folded.add(fitted.form().toString());
    } else if (isScatter(change)) {
      leftOut.add(fitted.form().toString());
    } else if (change instanceof NearEcho || change instanceof NearRange) {
      nearFields.add(fitted.form().toString());
    } else {
      throw new IllegalArgumentException(
          "effect "
              + fitted.form()
              + " "
              + fitted.values()
              + ": "
              + NO_FORM
              + (isLevel ? " where the sensor hears by the level law" : ""));
    }
  }

  private static boolean isScatter(Change change) {
    return change instanceof RangeNoise
        || (change instanceof NoiseTails tails && tails.share() < HALF)
        || (change instanceof Dropout dropout && dropout.share() < HALF);
  }

  private boolean takeGeometric(Change change) {
    if (change instanceof BeamMisalignment turned) {
      turnRad += turned.only().isEmpty() || model.sensors().size() == 1 ? turned.turnRad() : 0;
      return turned.only().isEmpty() || model.sensors().size() == 1;
    }
    if (change instanceof NearLimit limit) {
      geometric.add(change);
      ranges = ranges.clamped(limit.leastM());
      return true;
    }
    boolean geometry =
        change instanceof SceneChange || (isLevel ? isOfScatter(change) : isOfThreshold(change));
    if (geometry) {
      geometric.add(change);
    } else if (change instanceof DeadZone dead) {
      leastM = Math.max(leastM, dead.endM());
    } else if (change instanceof EarlyTimeout early) {
      mostM = Math.min(mostM, early.startM());
    } else if (change instanceof ReadingTimeout clock) {
      mostM = Math.min(mostM, clock.mostM());
    } else {
      return false;
    }
    return true;
  }

  private static boolean isOfThreshold(Change change) {
    return change instanceof SensorChange
        || (change instanceof ThresholdChange && !(change instanceof BeamPattern));
  }

  /** A factor of a threshold is no level; how far it weakens an echo depends on the distance. */
  private static boolean isOfScatter(Change change) {
    return change instanceof SensorScatter;
  }

  private boolean takeRange(Change change) {
    if (change instanceof SoundSpeed speed) {
      ranges = ranges.scaled(speed.scale());
    } else if (change instanceof AirTemperature air && air.follows() == 0) {
      ranges = ranges.scaled(air.scale());
    } else if (change instanceof RangeOffset offset) {
      ranges = ranges.shifted(offset.offsetM());
    } else if (change instanceof NearClamp clamp) {
      ranges = ranges.clamped(clamp.leastM());
    } else if (change instanceof CoarseResolution steps) {
      ranges = ranges.stepped(steps.stepM(), steps.reported());
    } else if (change instanceof NoEchoCode code && code.lostShare() < HALF) {
      ranges = code.share() >= HALF ? ranges.coded(code.codeM()) : ranges;
    } else {
      return false;
    }
    return true;
  }

  private boolean takeMemory(Change change) {
    if (change instanceof Hysteresis held && !isLevel) {
      hysteresis = Optional.of(held);
      return true;
    }
    boolean counted =
        change instanceof StaleReading stale
            && stale.equals(StaleReading.ofPings(stale.pings()))
            && stale.pings() <= StaleReading.MOST_REPEATS;
    if (counted) {
      repeats = (int) Math.floor(((StaleReading) change).pings() + HALF);
    }
    return counted;
  }

  /** Returns what is heard by the level law. */
  HeaderTarget levelTarget() {
    return levels.target(model, geometric, index, type(), sensor());
  }

  /** Returns the obstacle with the thresholds at which a sensor picks it up. */
  ObstacleType type() {
    return new ObstacleType(
        believed.name(),
        believed.outline(),
        new TableDocument(table(false), Map.of("object", believed.name())));
  }

  /** Returns the thresholds at which a sensor that heard it loses it. */
  ThresholdTable held() {
    return table(true);
  }

  private ThresholdTable table(boolean heardBefore) {
    double[] thresholds = thresholdsM();
    for (int i = 0; i < thresholds.length; i++) {
      double plain = thresholds[i];
      thresholds[i] =
          Math.max(0, hysteresis.map(h -> h.thresholdM(plain, heardBefore)).orElse(plain));
    }
    return ThresholdTable.of(thresholds);
  }

  /**
   * Thresholds by bearing as the effects leave them: asked of a sensor that looks at the centre.
   */
  private double[] thresholdsM() {
    Obstacle there = actual();
    int bearings = there.detection().findTable().map(ThresholdTable::size).orElse(BEARINGS);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < bearings; i++) {
      double bearing = i * Angles.TURN_RAD / bearings;
      Point at =
          there
              .worldFromObstacle()
              .worldFromObstacle(new Point(Math.sin(bearing), Math.cos(bearing)));
      Placement centre = there.worldFromObstacle();
      double heading = Math.atan2(at.zM() - centre.zM(), centre.xM() - at.xM());
      rows.add(
          new ReadingRow(
              "folded", "sensor", i, Pose.of(at.xM(), at.zM(), heading), NoEcho.NO_ECHO));
    }
    Geometry geometry = new Geometry(new PingLog(rows), model.setup(), geometric);
    double[] thresholds = new double[bearings];
    Arrays.setAll(thresholds, i -> thresholdM(geometry, i * geometry.obstacles() + index, i));
    return thresholds;
  }

  private double thresholdM(Geometry geometry, int line, int bearing) {
    int bearings = geometry.log().size();
    double threshold = actual().detection().thresholdM(bearing * Angles.TURN_RAD / bearings);
    for (ThresholdChange change : Change.only(ThresholdChange.class, geometric)) {
      threshold *= change.factor(geometry, line);
    }
    return threshold;
  }

  /** The obstacle as it is, not as it is believed. */
  private Obstacle actual() {
    Scene scene = model.setup().scene();
    for (SceneChange change : Change.only(SceneChange.class, geometric)) {
      scene = change.apply(scene);
    }
    return scene.obstacles().get(index);
  }

  /** Returns where it stands as seen from where it is believed to stand. */
  Placement moved() {
    Placement from = believed.worldFromObstacle();
    Placement to = actual().worldFromObstacle();
    Point centre = from.obstacleFromWorld(new Point(to.xM(), to.zM()));
    return new Placement(centre.xM(), centre.zM(), Angles.signed(to.turnRad() - from.turnRad()));
  }

  /** Returns the sensor, without scatter. */
  SonarSpec sensor() {
    SonarSpec figures = Geometry.changedSensor(model.setup().sensor(), geometric);
    SonarSpec changed = isLevel ? levels.sensor(figures) : figures;
    return changed.withRange(
        Math.max(changed.minRangeM(), leastM), Math.min(changed.maxRangeM(), mostM));
  }

  RangeFigures ranges() {
    return ranges;
  }

  double turnRad() {
    return turnRad + levels.squintRad();
  }

  int repeats() {
    return repeats;
  }

  /** Returns which effects are in it. */
  List<String> folded() {
    return List.copyOf(folded);
  }

  /** Returns which effects only scatter, and have no part in it. */
  List<String> leftOut() {
    return List.copyOf(leftOut);
  }

  /** Returns what is left out of where echoes come from near by. */
  List<String> nearFields() {
    return List.copyOf(nearFields);
  }
}
