package simbad.sonar.effect;

import java.util.Comparator;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.SightLine;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/**
 * Where every ping's sensor and the obstacles really are, and what the sensor sees of each: all
 * that costs time and that most changes leave alone. Line of sight {@code ping * obstacles() + o}
 * leads from a ping to obstacle o. Immutable, safe for use by several threads.
 */
public final class Geometry {
  private final PingLog log;
  private final Scene scene;
  private final double coneHalfAngleRad;
  private final int obstacles;
  private final double[] xM;
  private final double[] zM;
  private final double[] headingRad;
  private final double[] nearestM;
  private final double[] centreDistanceM;
  private final double[] bearingRad;
  private final double[] thresholdM;
  private final double[] offAxisRad;
  private final List<Outline> outlines;

  /**
   * Computes the geometry.
   *
   * @param log the pings
   * @param believed the set-up
   * @param changes of which those that act on poses, the scene and the cone count here
   */
  public Geometry(PingLog log, SensingSetup believed, List<? extends Change> changes) {
    this.log = log;
    scene = changedScene(believed.scene(), changes);
    SonarSpec sensor = changedSensor(believed.sensor(), changes);
    coneHalfAngleRad = sensor.coneHalfAngleRad();
    obstacles = scene.obstacles().size();
    int lines = log.size() * obstacles;
    xM = new double[log.size()];
    zM = new double[log.size()];
    headingRad = new double[log.size()];
    nearestM = new double[lines];
    centreDistanceM = new double[lines];
    bearingRad = new double[lines];
    thresholdM = new double[lines];
    offAxisRad = new double[lines];
    outlines = scene.obstacles().stream().map(Obstacle::worldOutline).toList();
    pose(changes);
    look(new NominalModel(sensor, scene));
  }

  /** Tells whether a change has to be known before geometry can be computed. */
  public static boolean dependsOn(Change change) {
    return change instanceof PoseChange
        || change instanceof SceneChange
        || change instanceof BeamWidth
        || change instanceof BeamEdge;
  }

  static Scene changedScene(Scene believed, List<? extends Change> changes) {
    Scene scene = believed;
    for (Change change : changes) {
      if (change instanceof SceneChange moves) {
        scene = moves.apply(scene);
      }
    }
    return scene;
  }

  static SonarSpec changedSensor(SonarSpec believed, List<? extends Change> changes) {
    SonarSpec sensor = believed;
    for (Change change : changes) {
      if (change instanceof SensorChange figures) {
        sensor = figures.apply(sensor);
      }
    }
    return sensor;
  }

  private void pose(List<? extends Change> changes) {
    PoseChange.PoseMap[] moves =
        changes.stream()
            .filter(PoseChange.class::isInstance)
            .map(PoseChange.class::cast)
            .sorted(Comparator.comparingInt(PoseChange::order))
            .map(change -> change.over(log))
            .toArray(PoseChange.PoseMap[]::new);
    TruePose pose = new TruePose();
    for (int i = 0; i < log.size(); i++) {
      pose.set(log.xM(i), log.zM(i), log.headingRad(i));
      for (PoseChange.PoseMap move : moves) {
        move.apply(i, pose);
      }
      xM[i] = pose.xM();
      zM[i] = pose.zM();
      headingRad[i] = pose.headingRad();
    }
  }

  private void look(NominalModel model) {
    SightLine sight = new SightLine();
    TransducerPose from = new TransducerPose();
    for (int ping = 0, line = 0; ping < log.size(); ping++) {
      from.aim(xM[ping], zM[ping], headingRad[ping]);
      for (int obstacle = 0; obstacle < obstacles; obstacle++, line++) {
        model.trace(obstacle, from, sight);
        nearestM[line] = sight.nearestM();
        centreDistanceM[line] = sight.centreDistanceM();
        bearingRad[line] = sight.bearingRad();
        thresholdM[line] = sight.thresholdM();
        offAxisRad[line] = offAxis(ping, scene.obstacles().get(obstacle));
      }
    }
  }

  /** Of the centre, from the heading; of no interest to what is not in the cone. */
  private double offAxis(int ping, Obstacle obstacle) {
    Placement place = obstacle.worldFromObstacle();
    double direction = Math.atan2(zM[ping] - place.zM(), place.xM() - xM[ping]);
    return Angles.signed(direction - headingRad[ping]);
  }

  /** Returns the pings. */
  public PingLog log() {
    return log;
  }

  /** Returns the scene as it is under the changes. */
  public Scene scene() {
    return scene;
  }

  /** Returns the cone's half angle under the changes, radians. */
  public double coneHalfAngleRad() {
    return coneHalfAngleRad;
  }

  /** Returns the number of obstacles. */
  public int obstacles() {
    return obstacles;
  }

  /** Returns the sensor's x in metres. */
  public double xM(int ping) {
    return xM[ping];
  }

  /** Returns the sensor's z in metres. */
  public double zM(int ping) {
    return zM[ping];
  }

  /** Returns the sensor's heading in radians. */
  public double headingRad(int ping) {
    return headingRad[ping];
  }

  /** Returns the distance to the obstacle's nearest point in the cone; infinity for none. */
  public double nearestM(int line) {
    return nearestM[line];
  }

  /** Returns the distance to the obstacle's centre, metres. */
  public double centreDistanceM(int line) {
    return centreDistanceM[line];
  }

  /** Returns the sensor's bearing in the obstacle's own frame, radians in [0, 2 pi). */
  public double bearingRad(int line) {
    return bearingRad[line];
  }

  /** Returns the believed threshold at that bearing, metres. */
  public double thresholdM(int line) {
    return thresholdM[line];
  }

  /**
   * Returns the angle from the heading to the obstacle's centre, radians in [-pi, pi], positive
   * counter-clockwise.
   */
  public double offAxisRad(int line) {
    return offAxisRad[line];
  }

  /**
   * Returns the least angle from the heading to any point of the obstacle's outline, radians in [0,
   * pi]; 0 where the axis meets it.
   */
  public double outlineOffAxisRad(int line) {
    int ping = line / obstacles;
    Outline outline = outlines.get(line % obstacles);
    double least = Math.PI;
    double from = cornerOffAxis(ping, outline, outline.size() - 1);
    for (int i = 0; i < outline.size(); i++) {
      double to = cornerOffAxis(ping, outline, i);
      if (from * to <= 0 && Math.abs(from - to) < Math.PI) {
        return 0;
      }
      least = Math.min(least, Math.abs(to));
      from = to;
    }
    return least;
  }

  private double cornerOffAxis(int ping, Outline outline, int corner) {
    double direction = Math.atan2(zM[ping] - outline.zM(corner), outline.xM(corner) - xM[ping]);
    return Angles.signed(direction - headingRad[ping]);
  }
}
