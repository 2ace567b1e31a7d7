package simbad.sonar.ping;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import simbad.sonar.level.Beam;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.StrengthDetection;

/**
 * What the level law makes of lines of sight: by how much an echo exceeds the threshold, and how
 * surely that is known. Immutable.
 */
public final class LevelEars {
  /** Nothing is fainter off the axis: between its lobes a real transducer hears a little. */
  private static final double LEAST_BEAM_DB = -60;

  /** Poses are known to a third of a degree or so; on the beam's flank that is a level. */
  private static final double AIM_RAD = Math.toRadians(0.35);

  /**
   * After its burst a transducer rings: an echo meets it in any phase. At 10 cm the sum strays by 6
   * dB, and by a factor e less for each 3.5 cm further.
   */
  private static final double RINGING_DB = 6;

  private static final double RINGING_FROM_M = 0.1;
  private static final double RINGING_FADES_M = 0.035;
  private static final double MOST_RINGING_DB = 12;

  /** Between the lobes a beam is so steep that no slope says how far it is off. */
  private static final double MOST_BEAM_DB = 10;

  private final LevelRule rule;
  private final List<Obstacle> obstacles;
  private final LevelStrength[] strength;
  private final EchoPath[] path;
  private final NearField[] near;
  private final List<NearRange> nearRanges;

  private LevelEars(
      LevelRule rule, Scene scene, List<String> labels, List<? extends Change> changes) {
    this.rule = rule;
    obstacles = scene.obstacles();
    strength = new LevelStrength[labels.size()];
    path = new EchoPath[labels.size()];
    near = new NearField[labels.size()];
    nearRanges = Change.only(NearRange.class, changes);
    for (int i = 0; i < strength.length; i++) {
      for (LevelStrength one : Change.only(LevelStrength.class, changes)) {
        strength[i] = one.isOf(labels.get(i)) ? one : strength[i];
      }
      for (EchoPath one : Change.only(EchoPath.class, changes)) {
        path[i] = one.isOf(labels.get(i)) ? one : path[i];
      }
      for (NearEcho one : Change.only(NearEcho.class, changes)) {
        near[i] = one.isOf(labels.get(i)) ? one.field().orElse(near[i]) : near[i];
      }
    }
  }

  /** What is read of a distance, as a share of it. */
  public double rangeScale() {
    return rule.rangeScale();
  }

  /** By how much an obstacle's echo comes from beyond its nearest point, metres. */
  public double addedM(Geometry geometry, int line) {
    double added = addedM(line % path.length, geometry.bearingRad(line));
    for (NearRange one : nearRanges) {
      added += one.addedM().at(geometry.nearestM(line));
    }
    return added;
  }

  /**
   * Returns the same from any bearing.
   *
   * @param obstacle index in the scene
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   */
  public double addedM(int obstacle, double bearingRad) {
    EchoPath known = path[obstacle];
    return known == null ? 0 : known.addedM().at(bearingRad);
  }

  /** How far that may be off, metres. */
  public double addedDeviationM(Geometry geometry, int line) {
    EchoPath known = path[line % path.length];
    return known == null ? 0 : known.deviationM().at(geometry.bearingRad(line));
  }

  /** Those of a sensor under its changes; null where it hears by thresholds. */
  static @Nullable LevelEars of(List<? extends Change> changes, Scene scene, List<String> labels) {
    List<LevelRule> rules = Change.only(LevelRule.class, changes);
    return rules.isEmpty() ? null : new LevelEars(rules.get(0), scene, labels, changes);
  }

  /** Tells whether an obstacle is heard as by others, where it and the pose are the same. */
  boolean hearLike(LevelEars others, int obstacle) {
    return rule.equals(others.rule)
        && nearRanges.equals(others.nearRanges)
        && Objects.equals(near[obstacle], others.near[obstacle])
        && Objects.equals(strength[obstacle], others.strength[obstacle])
        && Objects.equals(path[obstacle], others.path[obstacle]);
  }

  /** Returns the law. */
  public LevelLaw law() {
    return rule.law();
  }

  /**
   * Returns what a wider piston adds to the level in the direction of an obstacle's echo: it hears
   * there what this one hears further off its axis.
   *
   * @param factor of the radius, positive
   * @param geometry of all pings
   * @param line index of a ping's line of sight to an obstacle
   * @return decibels
   */
  public double widenedDb(double factor, Geometry geometry, int line) {
    double offAxis = geometry.echoOffAxisRad(line) - rule.squintRad();
    return widenedDb(law().beam(), offAxis, factor) - beamDb(law().beam(), offAxis);
  }

  /**
   * Returns the level of the beam of a piston whose radius is greater by a factor.
   *
   * @param beam of the piston
   * @param offAxisRad angle off the beam's axis
   * @param factor positive
   * @return decibels
   */
  public static double widenedDb(Beam beam, double offAxisRad, double factor) {
    // The directivity depends on the product of radius and sine; no direction has a sine over 1.
    double sine = Math.max(-1, Math.min(1, factor * Math.sin(offAxisRad)));
    return beamDb(beam, Math.asin(sine));
  }

  /**
   * Returns the level of a beam in a direction; never less than a real transducer hears there.
   *
   * @param beam sender and receiver
   * @param offAxisRad angle off the beam's axis
   * @return decibels
   */
  public static double beamDb(Beam beam, double offAxisRad) {
    return Math.max(LEAST_BEAM_DB, beam.twoWayDb(offAxisRad));
  }

  /**
   * What is known of the place that an obstacle's echo comes from; null for no more than before.
   */
  static @Nullable NearField near(@Nullable LevelEars ears, int obstacle) {
    return ears == null ? null : ears.near[obstacle];
  }

  /** Tells whether more is known of where an obstacle's echo comes from than its nearest point. */
  boolean hasNearField(int obstacle) {
    return near[obstacle] != null;
  }

  /** By how much its echo is stronger at this distance than its strength says, decibels. */
  public double nearDb(Geometry geometry, int line) {
    NearField known = near[line % near.length];
    return known == null
        ? 0
        : known.addedDb(geometry.bearingRad(line), geometry.centreDistanceM(line));
  }

  /** From where its echo comes, as an angle from the direction of its centre, radians. */
  double offCentreRad(Geometry geometry, int line) {
    return near[line % near.length].offCentreRad(
        geometry.bearingRad(line), geometry.centreDistanceM(line));
  }

  /** By how much the echo of an obstacle exceeds the threshold before any effect, decibels. */
  double excessDb(Geometry geometry, int line) {
    double offAxis = geometry.echoOffAxisRad(line) - rule.squintRad();
    return strengthDb(line % strength.length, geometry.bearingRad(line))
        + law().levelDb()
        + beamDb(law().beam(), offAxis)
        + nearDb(geometry, line)
        - law().lossDb(geometry.centreDistanceM(line));
  }

  /**
   * Returns how strongly an obstacle answers, as calibrated or else as believed.
   *
   * @param obstacle index in the scene
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi)
   * @return decibels; negative infinity where nothing ever answers
   */
  public double strengthDb(int obstacle, double bearingRad) {
    if (strength[obstacle] != null) {
      return strength[obstacle].strengthDb().strengthDb(bearingRad);
    }
    return obstacles.get(obstacle).detection() instanceof StrengthDetection stated
        ? stated.strength().strengthDb(bearingRad)
        : law().strengthDb(obstacles.get(obstacle).detection().thresholdM(bearingRad));
  }

  /** How far that may be off, from ping to ping and for want of knowledge, decibels. */
  double deviationDb(Geometry geometry, int line) {
    double offAxis = geometry.echoOffAxisRad(line) - rule.squintRad();
    double slope = slopeDb(law().beam(), offAxis);
    double unknown = unknownVariance(geometry, line, offAxis, slope);
    return Math.sqrt(knownVariance(slope, geometry.nearestM(line)) + unknown);
  }

  /** What strays from ping to ping, and with the beam's axis. */
  private double knownVariance(double slopeDb, double nearestM) {
    double own = law().excessSdDb();
    double aim = Math.abs(slopeDb) * AIM_RAD;
    double squint = aim * rule.squintDeviationRad() / AIM_RAD;
    double ringing = ringingDb(nearestM);
    return own * own + aim * aim + ringing * ringing + squint * squint;
  }

  /**
   * Returns by how much an echo exceeds the threshold that comes from no obstacle of the scene.
   *
   * @param strengthDb target strength of what sends it back, decibels
   * @param offAxisRad angle from the heading, positive counter-clockwise
   * @param distanceM of what sends it back, metres
   * @return decibels
   */
  public double excessDb(double strengthDb, double offAxisRad, double distanceM) {
    return strengthDb
        + law().levelDb()
        + beamDb(law().beam(), offAxisRad - rule.squintRad())
        - law().lossDb(distanceM);
  }

  /** Returns how far that may be off, decibels; parameters as of {@link #excessDb}. */
  public double deviationDb(double offAxisRad, double distanceM) {
    double slope = slopeDb(law().beam(), offAxisRad - rule.squintRad());
    return Math.sqrt(knownVariance(slope, distanceM));
  }

  /** Tells whether the sensor listens for echoes from a distance, metres. */
  public boolean isInRange(double distanceM) {
    return distanceM >= rule.minRangeM() && distanceM <= rule.maxRangeM();
  }

  /** Returns the share of audible echoes that are not lost, in [0, 1]. */
  public double heardShare() {
    return 1 - rule.missRate();
  }

  /** A beam too wide has been taken for a target too weak. */
  private double unknownVariance(Geometry geometry, int line, double offAxisRad, double slopeDb) {
    int obstacle = line % strength.length;
    double bearingRad = geometry.bearingRad(line);
    // A piston hears at an angle what a narrower one hears further off its axis.
    double turned = Math.tan(offAxisRad) * rule.apertureDeviation();
    double strayed = turned * slopeDb;
    double beam = Math.max(-MOST_BEAM_DB, Math.min(MOST_BEAM_DB, strayed));
    if (strength[obstacle] == null) {
      return beam * beam;
    }
    double common = strength[obstacle].withApertureDb().strengthDb(bearingRad);
    double own = strength[obstacle].deviationDb().strengthDb(bearingRad);
    double apart = Math.max(0, own * own - common * common);
    return apart + (common + beam) * (common + beam);
  }

  /**
   * Returns by how much a level strays because the heading is not known better.
   *
   * @param beam sender and receiver
   * @param offAxisRad angle off the beam's axis
   * @return decibels, at least 0
   */
  public static double aimDb(Beam beam, double offAxisRad) {
    return Math.abs(slopeDb(beam, offAxisRad)) * AIM_RAD;
  }

  /** Decibels for each radian. */
  private static double slopeDb(Beam beam, double offAxisRad) {
    double rise = beamDb(beam, offAxisRad + AIM_RAD) - beamDb(beam, offAxisRad - AIM_RAD);
    return rise / (2 * AIM_RAD);
  }

  /**
   * Returns by how much the ringing of the sender makes a level stray.
   *
   * @param nearestM distance of what answers, metres
   * @return decibels, at least 0
   */
  public static double ringingDb(double nearestM) {
    double fading = Math.exp((RINGING_FROM_M - nearestM) / RINGING_FADES_M);
    return Math.min(MOST_RINGING_DB, RINGING_DB * fading);
  }
}
