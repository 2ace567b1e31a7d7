package simbad.sonar.predict;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.level.Decibels;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.EchoPath;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.LevelStrength;
import simbad.sonar.ping.QuickNormal;
import simbad.sonar.scene.SonarSpec;

/**
 * What the level law lets arrive of one ping: echoes that overlap add their energies, and each is
 * read late by the walk of its excess. A buffer that is filled anew.
 */
final class LevelHearing {
  private final Geometry geometry;
  private final LevelEars ears;
  private final LevelLaw law;
  private final LevelChange[] changes;
  private final double minRangeM;
  private final double stepM;
  private final double maxRangeM;
  private final double heardShare;

  /** By which changes let the excess scatter more, decibels. */
  private final double moreScatterDb;

  private int size;
  private double[] distanceM = new double[2];
  private double[] excessDb = new double[2];

  /** By how much an echo comes from beyond its obstacle's nearest point, and how surely. */
  private double[] addedM = new double[2];

  private double[] addedDeviationM = new double[2];

  /** How far the excess may be off, and what of the chance of an echo is left. */
  private double[] deviationDb = new double[2];

  private double[] kept = new double[2];

  /** Of hysteresis: what the excess is after an echo, and how surely there was one. */
  private double[] heldDb = new double[2];

  private double[] held = new double[2];

  LevelHearing(Geometry geometry, SonarSpec sensor, List<? extends Change> changes) {
    this.geometry = geometry;
    ears = java.util.Objects.requireNonNull(geometry.ears());
    law = ears.law();
    this.changes =
        Change.only(LevelChange.class, changes).stream()
            .filter(change -> !(change instanceof LevelStrength || change instanceof EchoPath))
            .toArray(LevelChange[]::new);
    minRangeM = sensor.minRangeM();
    stepM = LevelRule.leastRangeStepM(sensor);
    maxRangeM = sensor.maxRangeM();
    heardShare = 1 - sensor.missRate();
    double variance = 0;
    for (LevelChange change : this.changes) {
      variance += change.scatterDb() * change.scatterDb();
    }
    moreScatterDb = Math.sqrt(variance);
  }

  void clear() {
    size = 0;
  }

  boolean isInRange(int line) {
    double nearest = geometry.nearestM(line);
    return nearest > minRangeM - stepM && nearest <= maxRangeM;
  }

  /** The chance that the sensor hears so near: its least range lies anywhere in the last step. */
  private double nearShare(double nearestM) {
    return Math.min(1, (nearestM - minRangeM) / stepM + 1);
  }

  /**
   * Adds what an obstacle answers.
   *
   * @param line of sight to it
   * @param factor of its threshold: it is heard as from so much less far
   * @param hysteresis of its threshold, or null
   * @param heldShare how surely the ping before heard it
   * @param keptShare what effects leave of its chance
   */
  void add(
      int line,
      double factor,
      @Nullable Hysteresis hysteresis,
      double heldShare,
      double keptShare) {
    if (size == distanceM.length) {
      grow();
    }
    double excess = geometry.excessDb(line);
    double deviation = Deviations.together(geometry.excessDeviationDb(line), moreScatterDb);
    for (LevelChange change : changes) {
      excess += change.addedDb(ears, geometry, line);
      deviation = Deviations.together(deviation, change.deviationDb(geometry, line));
    }
    distanceM[size] = geometry.nearestM(line);
    deviationDb[size] = deviation;
    addedM[size] = geometry.pathM(line);
    addedDeviationM[size] = geometry.pathDeviationM(line);
    kept[size] = keptShare * heardShare * nearShare(distanceM[size]);
    held[size] = heldShare;
    excessDb[size] =
        scaled(excess, line, hysteresis == null ? factor : factor(hysteresis, factor, line, false));
    heldDb[size] =
        hysteresis == null
            ? excessDb[size]
            : scaled(excess, line, factor(hysteresis, factor, line, true));
    size++;
  }

  private double factor(Hysteresis hysteresis, double factor, int line, boolean heardBefore) {
    double threshold = geometry.thresholdM(line);
    return threshold > 0
        ? Math.max(0, hysteresis.thresholdM(factor * threshold, heardBefore) / threshold)
        : factor;
  }

  /** With a threshold of twice the distance an echo is heard as from half as far. */
  private double scaled(double excess, int line, double factor) {
    if (factor == 1) {
      return excess;
    }
    double centre = geometry.centreDistanceM(line);
    return factor > 0
        ? excess + law.lossDb(centre) - law.lossDb(centre / factor)
        : Double.NEGATIVE_INFINITY;
  }

  private void grow() {
    int room = 2 * size;
    distanceM = Arrays.copyOf(distanceM, room);
    excessDb = Arrays.copyOf(excessDb, room);
    addedM = Arrays.copyOf(addedM, room);
    addedDeviationM = Arrays.copyOf(addedDeviationM, room);
    deviationDb = Arrays.copyOf(deviationDb, room);
    kept = Arrays.copyOf(kept, room);
    heldDb = Arrays.copyOf(heldDb, room);
    held = Arrays.copyOf(held, room);
  }

  /**
   * Adds to what arrives each echo at the distance that it reads.
   *
   * @param arrivals takes them
   * @param placed whether it matters where; else the chances alone are right
   */
  void into(Arrivals arrivals, boolean placed) {
    // Of several it matters which is the first.
    boolean ranged = placed || size > 1;
    for (int i = 0; i < size; i++) {
      double more = size == 1 ? 0 : addedDb(i);
      double excess = excessDb[i] + more;
      double chance = kept[i] * QuickNormal.atMost(excess, deviationDb[i]);
      if (held[i] > 0) {
        double after = kept[i] * QuickNormal.atMost(heldDb[i] + more, deviationDb[i]);
        chance += held[i] * (after - chance);
      }
      if (!(chance > 0)) {
        continue;
      }
      if (!ranged) {
        arrivals.add(0, 0, chance);
        continue;
      }
      double readM = ears.rangeScale() * distanceM[i] + addedM[i] + law.walkM().at(excess);
      arrivals.add(readM, Deviations.together(law.noiseM().at(excess), addedDeviationM[i]), chance);
    }
  }

  /** What echoes that came less than a pulse before add to one. */
  private double addedDb(int echo) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      double before = distanceM[echo] - distanceM[i];
      if (i != echo && before >= 0 && before <= law.pulseLengthM()) {
        sum += Decibels.energy(excessDb[i] - excessDb[echo]);
      }
    }
    return sum == 0 ? 0 : Decibels.level(1 + sum);
  }
}
