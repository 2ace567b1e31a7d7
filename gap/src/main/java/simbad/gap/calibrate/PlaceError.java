package simbad.gap.calibrate;

import java.util.function.IntPredicate;
import simbad.gap.unexplained.SetupScores;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.ping.Geometry;

/**
 * By how much levels and ranges are off from place to place, beyond chance: of each obstacle at
 * each of some distances. An estimate by moments, as of differences between studies (DerSimonian
 * and Laird 1986).
 */
final class PlaceError {
  private final double[][] score = new double[2][];
  private final double[][] information = new double[2][];

  /** Creates one for a log before some obstacles. */
  PlaceError(int obstacles) {
    for (int kind = 0; kind < 2; kind++) {
      score[kind] = new double[obstacles * LevelForms.RECEIVER_M.size()];
      information[kind] = new double[score[kind].length];
    }
  }

  /** Takes the scores of some pings. */
  void take(SetupScores scores, IntPredicate held) {
    for (int ping = 0; ping < scores.perDecibel().length; ping++) {
      if (held.test(ping)) {
        int cell = cell(scores.geometry(), ping);
        add(0, cell, scores.perDecibel()[ping]);
        add(1, cell, scores.perMetre()[ping]);
      }
    }
  }

  private void add(int kind, int cell, double slope) {
    score[kind][cell] += slope;
    information[kind][cell] += slope * slope;
  }

  private static int cell(Geometry geometry, int ping) {
    int obstacles = geometry.obstacles();
    int nearest = 0;
    for (int target = 1; target < obstacles; target++) {
      boolean nearer =
          geometry.nearestM(ping * obstacles + target)
              < geometry.nearestM(ping * obstacles + nearest);
      nearest = nearer ? target : nearest;
    }
    double distance = geometry.nearestM(ping * obstacles + nearest);
    return nearest * LevelForms.RECEIVER_M.size() + LevelForms.receiverKnot(distance);
  }

  /** Returns by how much levels are off, decibels. */
  double excessDb() {
    return spread(0);
  }

  /** Returns by how much ranges are off, metres. */
  double rangeM() {
    return spread(1);
  }

  private double spread(int kind) {
    double over = 0;
    double sum = 0;
    for (int cell = 0; cell < score[kind].length; cell++) {
      double own = information[kind][cell];
      if (own > 0) {
        over += score[kind][cell] * score[kind][cell] / own - 1;
        sum += own;
      }
    }
    return sum > 0 ? Math.sqrt(Math.max(0, over / sum)) : 0;
  }
}
