package simbad.sonar.ping;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import simbad.sonar.frame.Angles;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.SightLine;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * Where every ping's sensor and the obstacles really are, and what the sensor sees of each: all
 * that costs time and that most changes leave alone. Line of sight {@code ping * obstacles() + o}
 * leads from a ping to obstacle o. That of a log is immutable and safe for use by several threads.
 */
public final class Geometry {
  private final PingLog log;
  private final Scene scene;
  private final SonarSpec sensor;
  private final NominalModel model;
  private final int obstacles;
  private final List<String> labels;
  private final OffAxis angles;
  private final double[] xM;
  private final double[] zM;
  private final double[] headingRad;
  final double[] nearestM;

  /** Of pings of no log: what {@link #nearestM} was when the transducer looked before. */
  private final double[] formerM;

  final double[] centreDistanceM;
  final double[] bearingRad;
  final double[] thresholdM;

  /** Of the bearing: not a number until it is asked for. */
  final double[] bearingCos;

  final double[] bearingSin;

  /** Not a number until it is asked for; two threads that compute it find the same. */
  final double[] offAxisRad;

  final double[] outlineOffAxisRad;

  final double[] echoOffAxisRad;

  /** Of lines under the level law, each by itself: not a number until it is asked for. */
  final double[] excessDb;

  final double[] excessDeviationDb;
  final double[] pathM;
  final double[] pathDeviationM;

  private final boolean[] empty;

  private final @Nullable LevelEars ears;

  /** Of pings of no log: how often each transducer has looked. */
  private final int[] sent;

  /** Since the first ping of the log, or of the run for pings of no log, seconds. */
  private final double[] sinceStartS;

  private final SightLine sight = new SightLine();
  private final TransducerPose from = new TransducerPose();

  /**
   * Computes the geometry.
   *
   * @param log the pings
   * @param believed the set-up
   * @param changes of which those that act on poses, the scene and the cone count here
   */
  public Geometry(PingLog log, SensingSetup believed, List<? extends Change> changes) {
    this(log, believed, changes, null, null);
  }

  /**
   * Computes the geometry like another one, takes over from it what is the same, and may leave out
   * pings.
   *
   * @param log the pings
   * @param believed the set-up
   * @param changes of which those that act on poses, the scene and the cone count here
   * @param like of the same pings and set-up under other changes, of the pings that are asked for
   *     at least; null for none
   * @param only which pings are asked for, null for all; what is left for others means nothing
   */
  public Geometry(
      PingLog log,
      SensingSetup believed,
      List<? extends Change> changes,
      @Nullable Geometry like,
      boolean @Nullable [] only) {
    this(log, log.size(), believed, changes);
    Likeness likeness = like == null ? null : new Likeness(like, this);
    LoggedPoses poses = new LoggedPoses(log, changes);
    TruePose pose = new TruePose();
    for (int ping = 0; ping < log.size(); ping++) {
      poses.next(ping, pose);
      stand(ping, pose, log.timeS(ping) - log.firstS());
      if (only == null || only[ping]) {
        look(likeness, ping);
      }
    }
  }

  /** Of pings that are yet to be sent, and of no log: {@link #look} makes each as it is sent. */
  public Geometry(int pings, SensingSetup believed, List<? extends Change> changes) {
    this(new PingLog(List.of()), pings, believed, changes);
  }

  private Geometry(PingLog log, int pings, SensingSetup believed, List<? extends Change> changes) {
    this.log = log;
    scene = changedScene(believed.scene(), changes);
    sensor = changedSensor(believed.sensor(), changes);
    model = new NominalModel(sensor, scene);
    obstacles = scene.obstacles().size();
    labels = Scenes.labels(scene);
    angles = new OffAxis(this);
    int lines = pings * obstacles;
    xM = new double[pings];
    zM = new double[pings];
    headingRad = new double[pings];
    nearestM = new double[lines];
    formerM = new double[log.size() == 0 ? lines : 0];
    Arrays.fill(formerM, Double.POSITIVE_INFINITY);
    centreDistanceM = new double[lines];
    bearingRad = new double[lines];
    bearingCos = new double[lines];
    bearingSin = new double[lines];
    thresholdM = new double[lines];
    offAxisRad = new double[lines];
    outlineOffAxisRad = new double[lines];
    echoOffAxisRad = new double[lines];
    ears = LevelEars.of(changes, scene, labels);
    excessDb = new double[ears == null ? 0 : lines];
    excessDeviationDb = new double[excessDb.length];
    pathM = new double[excessDb.length];
    pathDeviationM = new double[excessDb.length];
    empty = new boolean[pings];
    sent = new int[pings];
    sinceStartS = new double[pings];
  }

  /** Tells whether a change has to be known before geometry can be computed. */
  public static boolean dependsOn(Change change) {
    return change.changesGeometry();
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

  /** Returns the sensor's figures with all changes of them. */
  public static SonarSpec changedSensor(SonarSpec believed, List<? extends Change> changes) {
    SonarSpec sensor = believed;
    for (Change change : changes) {
      if (change instanceof SensorChange figures) {
        sensor = figures.apply(sensor);
      }
    }
    return sensor;
  }

  /**
   * Returns how many pings its transducer sent before a ping since the start of the run, of those
   * that are known.
   */
  public int order(int ping) {
    return ping < log.size() ? ping - log.sequenceStart(ping) : sent[ping] - 1;
  }

  /** Forgets what transducers of no log saw: another run begins. */
  public void restart() {
    Arrays.fill(sent, 0);
    Arrays.fill(formerM, Double.POSITIVE_INFINITY);
  }

  /** Looks from a pose, which is where the sensor really is, at the time of the first ping. */
  public void look(int ping, TruePose pose) {
    look(ping, pose, 0);
  }

  /**
   * Looks from a pose.
   *
   * @param ping index
   * @param pose where the sensor really is
   * @param sinceS time since the first ping, seconds
   */
  public void look(int ping, TruePose pose, double sinceS) {
    stand(ping, pose, sinceS);
    look(null, ping);
  }

  private void stand(int ping, TruePose pose, double sinceS) {
    sinceStartS[ping] = sinceS;
    xM[ping] = pose.xM();
    zM[ping] = pose.zM();
    headingRad[ping] = pose.headingRad();
    sent[ping]++;
  }

  private void look(@Nullable Likeness likeness, int ping) {
    if (ping < log.size() && headingRad[ping] == log.headingRad(ping)) {
      // A fit looks from the same poses thousands of times.
      from.aim(xM[ping], zM[ping], log.directionX(ping), log.directionZ(ping));
    } else {
      from.aim(xM[ping], zM[ping], headingRad[ping]);
    }
    empty[ping] = true;
    for (int obstacle = 0; obstacle < obstacles; obstacle++) {
      int line = ping * obstacles + obstacle;
      if (formerM.length > 0 && sent[ping] > 1) {
        formerM[line] = nearestM[line];
      }
      forget(line);
      if (likeness == null || !likeness.sees(ping, obstacle)) {
        trace(line, obstacle);
      }
      empty[ping] &= nearestM[line] == Double.POSITIVE_INFINITY;
    }
  }

  private void forget(int line) {
    bearingCos[line] = Double.NaN;
    bearingSin[line] = Double.NaN;
    offAxisRad[line] = Double.NaN;
    outlineOffAxisRad[line] = Double.NaN;
    echoOffAxisRad[line] = Double.NaN;
    if (ears != null) {
      excessDb[line] = Double.NaN;
      excessDeviationDb[line] = Double.NaN;
      pathM[line] = Double.NaN;
      pathDeviationM[line] = Double.NaN;
    }
  }

  private void trace(int line, int obstacle) {
    model.trace(obstacle, from, sight);
    nearestM[line] = sight.nearestM();
    centreDistanceM[line] = sight.centreDistanceM();
    bearingRad[line] = sight.bearingRad();
    thresholdM[line] = sight.thresholdM();
  }

  /** The distance to an obstacle's nearest point in the cone from where it is looked now. */
  double nearestNowM(int obstacle) {
    return model.nearestM(obstacle, from);
  }

  /** Returns the pings. */
  public PingLog log() {
    return log;
  }

  /** Returns the scene as it is under the changes. */
  public Scene scene() {
    return scene;
  }

  /** Returns the sensor's figures under the changes. */
  public SonarSpec sensor() {
    return sensor;
  }

  /** Returns the cone's half angle under the changes, radians. */
  public double coneHalfAngleRad() {
    return sensor.coneHalfAngleRad();
  }

  /** By what the sensor hears if not by thresholds; null where it hears by them. */
  public @Nullable LevelEars ears() {
    return ears;
  }

  /** By how much an obstacle's echo exceeds the threshold under the level law, decibels. */
  public double excessDb(int line) {
    if (Double.isNaN(excessDb[line])) {
      excessDb[line] = Objects.requireNonNull(ears).excessDb(this, line);
    }
    return excessDb[line];
  }

  /** How far that may be off, decibels. */
  public double excessDeviationDb(int line) {
    if (Double.isNaN(excessDeviationDb[line])) {
      excessDeviationDb[line] = Objects.requireNonNull(ears).deviationDb(this, line);
    }
    return excessDeviationDb[line];
  }

  /** By how much its echo comes from beyond its nearest point, metres. */
  public double pathM(int line) {
    if (Double.isNaN(pathM[line])) {
      pathM[line] = Objects.requireNonNull(ears).addedM(this, line);
    }
    return pathM[line];
  }

  /** How far that may be off, metres. */
  public double pathDeviationM(int line) {
    if (Double.isNaN(pathDeviationM[line])) {
      pathDeviationM[line] = Objects.requireNonNull(ears).addedDeviationM(this, line);
    }
    return pathDeviationM[line];
  }

  /**
   * Returns what changes add to the excess of an obstacle's echo, decibels; 0 for a sensor that
   * hears by thresholds.
   *
   * @param changes of which those of the level law count
   * @param line of sight
   */
  public double addedDb(List<? extends Change> changes, int line) {
    double added = 0;
    for (Change change : changes) {
      if (ears != null && change instanceof LevelChange level) {
        added += level.addedDb(ears, this, line);
      }
    }
    return added;
  }

  /**
   * Returns what changes leave of the chance that an obstacle's echo is heard and not lost.
   *
   * @param changes of which those of echoes and losses count
   * @param line of sight
   */
  public double share(List<? extends Change> changes, int line) {
    double share = 1;
    for (Change change : changes) {
      if (change instanceof EchoChange echo) {
        share *= echo.share(this, line);
      } else if (change instanceof LossChange loss) {
        share *= 1 - loss.share(this, line / obstacles);
      }
    }
    return share;
  }

  /** The number of pings that there is room for. */
  public int pings() {
    return xM.length;
  }

  /** Returns the number of obstacles. */
  public int obstacles() {
    return obstacles;
  }

  /**
   * Returns the time since the first ping of the log, or of the run for pings of no log, seconds.
   */
  public double sinceStartS(int ping) {
    return sinceStartS[ping];
  }

  /** Returns whether no obstacle has a point in the cone. */
  public boolean isEmpty(int ping) {
    return empty[ping];
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

  /** Returns the label of the obstacle that a line leads to. */
  public String label(int line) {
    return labels.get(line % obstacles);
  }

  /** Returns the distance to the obstacle's nearest point in the cone; infinity for none. */
  public double nearestM(int line) {
    return nearestM[line];
  }

  /**
   * Returns the distance to the obstacle's nearest point in the cone at the ping that the same
   * transducer sent before in its run; infinity for none.
   */
  public double nearestBeforeM(int line) {
    if (formerM.length > 0) {
      return formerM[line];
    }
    int ping = line / obstacles;
    return log.sequenceStart(ping) == ping ? Double.POSITIVE_INFINITY : nearestM[line - obstacles];
  }

  /** Returns the distance to the obstacle's centre, metres. */
  public double centreDistanceM(int line) {
    return centreDistanceM[line];
  }

  /**
   * Returns the sensor's bearing in the obstacle's own frame, radians in [0, 2 pi); 0 where no
   * point of the obstacle is in the cone.
   */
  public double bearingRad(int line) {
    return bearingRad[line];
  }

  /** Returns the cosine of that bearing: a fit asks for it thousands of times. */
  public double bearingCos(int line) {
    if (Double.isNaN(bearingCos[line])) {
      bearingCos[line] = Math.cos(bearingRad[line]);
    }
    return bearingCos[line];
  }

  /** Returns the sine of that bearing. */
  public double bearingSin(int line) {
    if (Double.isNaN(bearingSin[line])) {
      bearingSin[line] = Math.sin(bearingRad[line]);
    }
    return bearingSin[line];
  }

  /** Returns the believed threshold at that bearing, metres; 0 where none is in the cone. */
  public double thresholdM(int line) {
    return thresholdM[line];
  }

  /**
   * Returns the angle from the heading to the obstacle's centre, radians in [-pi, pi], positive
   * counter-clockwise.
   */
  public double offAxisRad(int line) {
    if (Double.isNaN(offAxisRad[line])) {
      offAxisRad[line] = angles.ofCentre(line);
    }
    return offAxisRad[line];
  }

  /**
   * Returns the least angle from the heading to any point of the obstacle's outline, radians in [0,
   * pi]; 0 where the axis meets it.
   */
  public double outlineOffAxisRad(int line) {
    if (Double.isNaN(outlineOffAxisRad[line])) {
      outlineOffAxisRad[line] = angles.ofOutline(line);
    }
    return outlineOffAxisRad[line];
  }

  /**
   * Returns the angle from the heading to where an obstacle's echo comes from: the point that is
   * nearest in the cone, or what a calibration under the level law knows better.
   *
   * @return radians in [-pi, pi], positive counter-clockwise; the cone's half angle where the
   *     obstacle has no point in the cone
   */
  public double echoOffAxisRad(int line) {
    if (Double.isNaN(echoOffAxisRad[line])) {
      echoOffAxisRad[line] =
          ears != null && ears.hasNearField(line % obstacles)
              ? centreOfEcho(ears, line)
              : angles.ofNearest(line);
    }
    return echoOffAxisRad[line];
  }

  private double centreOfEcho(LevelEars known, int line) {
    return nearestM[line] == Double.POSITIVE_INFINITY
        ? coneHalfAngleRad()
        : Angles.signed(offAxisRad(line) + known.offCentreRad(this, line));
  }
}
