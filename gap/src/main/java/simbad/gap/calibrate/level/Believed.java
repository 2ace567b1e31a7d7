package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.ping.NearField;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;

/**
 * What a scene says of one obstacle's strength, by the orbits of its symmetry: that of its
 * thresholds, which moves with the loss over distance, and how surely. Immutable.
 */
final class Believed {
  /** A threshold so short says "weak" and little more: the receiver's recovery hides the rest. */
  static final double WEAK_M = 0.2;

  /** Where no other threshold of an obstacle says more. */
  private static final double WEAK_DB = -6;

  /**
   * A table that is as long as the sensor's range says "at least so strong". Departures from it are
   * taken for normal with 5 dB, of which only those upwards are left: they have this mean, and a
   * standard deviation of 3 dB.
   */
  private static final double AT_LEAST_DB = 4;

  /** As long as the range is what lies within a table's last step of it. */
  private static final double END_SHARE = 0.98;

  /** A table is read off to so much where it is flat. */
  private static final double TABLE_DB = 0.8;

  /** And its bearings to so much, which counts where it is steep. */
  private static final double TURNTABLE_DEG = 0.5;

  /**
   * An echo comes from somewhere on an outline: behind its nearest point, by a part of its size. A
   * burst's length in the air, 3 cm, is as far as it is still heard as one.
   */
  private static final double DEPTH_SHARE = 0.3;

  private static final double MOST_PATH_M = 0.03;

  private static final int SIZE = LevelForms.BEARINGS;

  private final Symmetry symmetry;
  private final double reachM;
  private final double[] believed;
  private final double[] thresholdM;
  private final double endM;
  private final OutlineLobes lobes;

  /** One figure for all bearings says nothing of any of them. */
  private final boolean isUniform;

  private final List<Loss> table = new ArrayList<>();
  private final Loss[] loss;
  private final double[] precision;

  /**
   * Reads an obstacle's detection.
   *
   * @param obstacle its outline and its thresholds or strengths
   * @param sensor of which the range and the carrier count: a table says no more of what is heard
   *     to the end of the range
   */
  Believed(Obstacle obstacle, SonarSpec sensor) {
    LevelLaw law = sensor.levelLaw();
    symmetry = Symmetry.of(obstacle.outline());
    reachM = obstacle.outline().reachM(0, 0);
    believed = Loss.values(law);
    thresholdM = thresholds(obstacle.detection());
    isUniform = obstacle.detection() instanceof UniformDetection;
    boolean isTable = obstacle.detection() instanceof TableDetection;
    endM = isTable ? END_SHARE * sensor.maxRangeM() : Double.POSITIVE_INFINITY;
    lobes =
        new OutlineLobes(
            new NearField(obstacle, LevelForms.wavenumberPerM(sensor)),
            thresholdM.length,
            i -> thresholdM[i] >= WEAK_M && thresholdM[i] < endM,
            i -> Loss.at(thresholdM[i], law).decibels(believed));
    for (int i = 0; i < thresholdM.length; i++) {
      table.add(loss(obstacle.detection(), i, law));
    }
    loss = new Loss[symmetry.orbits()];
    precision = new double[loss.length];
    for (int orbit = 0; orbit < loss.length; orbit++) {
      settle(orbit);
    }
  }

  private static double[] thresholds(Detection detection) {
    if (detection instanceof TableDetection) {
      return detection.findTable().orElseThrow().valuesM();
    }
    double[] all = new double[SIZE];
    Arrays.setAll(all, i -> detection.thresholdM(i * Angles.TURN_RAD / SIZE));
    return all;
  }

  private Loss loss(Detection detection, int at, LevelLaw law) {
    if (detection instanceof StrengthDetection stated) {
      double strength = stated.strength().strengthDb(at * Angles.TURN_RAD / SIZE);
      return Loss.constant(strength + law.levelDb() + law.beam().axisDb());
    }
    if (thresholdM[at] >= WEAK_M) {
      return Loss.at(thresholdM[at], law);
    }
    Loss shortest = Loss.at(WEAK_M, law);
    return shortest.plus(lobes.weakerDb(at, shortest.decibels(believed), WEAK_DB));
  }

  private void settle(int orbit) {
    List<Loss> onPoints = new ArrayList<>();
    List<Loss> between = new ArrayList<>();
    double seen = 0;
    double steep = 0;
    boolean isAtLeast = true;
    for (int bearing = 0; bearing < SIZE; bearing++) {
      if (symmetry.orbit(bearing) == orbit) {
        double place = (double) bearing * thresholdM.length / SIZE;
        int nearest = (int) Math.rint(place) % thresholdM.length;
        isAtLeast &= isAtEnd(Math.floor(place)) && isAtEnd(Math.ceil(place));
        if (Math.abs(place - Math.rint(place)) * SIZE <= thresholdM.length / 2.0) {
          onPoints.add(table.get(nearest));
          seen += thresholdM[nearest] >= WEAK_M ? 1 : 0;
          steep += slopeDb(nearest) * slopeDb(nearest);
        } else {
          between.add(between(place));
        }
      }
    }
    loss[orbit] = Loss.mean(onPoints.isEmpty() ? between : onPoints);
    if (isAtLeast) {
      loss[orbit] = loss[orbit].plus(AT_LEAST_DB);
    } else if (seen > 0 && !isUniform) {
      double flat = TABLE_DB * TABLE_DB + variance(onPoints);
      precision[orbit] = seen / (flat + steep / onPoints.size());
    }
  }

  private boolean isAtEnd(double point) {
    return thresholdM[(int) point % thresholdM.length] >= endM;
  }

  private Loss between(double place) {
    int cell = (int) place;
    Loss line = table.get(cell).towards(table.get((cell + 1) % table.size()), place - cell);
    return line.plus(lobes.aboveLineDb(place));
  }

  /** By what a table's value is off where its bearing is. */
  private double slopeDb(int at) {
    int size = table.size();
    double before = table.get((at + size - 1) % size).decibels(believed);
    double here = table.get(at).decibels(believed);
    double after = table.get((at + 1) % size).decibels(believed);
    double rise = (Math.abs(here - before) + Math.abs(after - here)) / 2;
    return rise * TURNTABLE_DEG * size / 360;
  }

  private double variance(List<Loss> all) {
    double mean = Loss.mean(all).decibels(believed);
    return all.stream()
        .mapToDouble(one -> Math.pow(one.decibels(believed) - mean, 2))
        .average()
        .orElse(0);
  }

  /** How far behind an outline's nearest point an echo may come from: standard deviation. */
  double pathSpreadM() {
    return Math.min(MOST_PATH_M, DEPTH_SHARE * reachM);
  }

  Symmetry symmetry() {
    return symmetry;
  }

  int orbits() {
    return loss.length;
  }

  /** The level that an orbit's strength makes up for on the axis. */
  Loss loss(int orbit) {
    return loss[orbit];
  }

  /** How surely the orbit departs from that by nothing: 1 / variance, 0 where nothing is known. */
  double precision(int orbit) {
    return precision[orbit];
  }
}
