package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import simbad.blindworld.wave.WaveWorld;

/**
 * Which of gain, absorption and early-timeout lose the same echoes as a change does, with the best
 * size of each: those against which an observer who knew both worlds by heart would expect odds of
 * less than 100 to 1 from the rows that are heard and lost. Each is heard by chance, by its level
 * over the threshold.
 */
final class Rivals {

  private static final double SAME_NATS = StrictMath.log(100);

  /** By which levels scatter at the threshold, by noise and by the air. */
  private static final double SCATTER_DB = 0.7;

  /** No row is sure. */
  private static final double LEAST_CHANCE = 0.01;

  private static final double SILENT_DB = -99;

  /** Rows further under the threshold in both worlds say nothing. */
  private static final double CONCERNED_DB = -6;

  private final Site site;
  private final List<double[]> rows = new ArrayList<>();

  private Rivals(Site site) {
    this.site = site;
  }

  /** A size of a law: the level of a row over the threshold by it, in decibels. */
  private interface Law {
    double excessDb(double excessDb, double distanceM, double size);
  }

  /** Names whose law loses the same echoes as the effect; its own name is not among them. */
  static List<Set<String>> of(WaveEffect effect, Site site) {
    Rivals rivals = new Rivals(site);
    rivals.listen(effect);
    List<Set<String>> same = new ArrayList<>();
    rivals.add(same, effect, "gain", sizes(-20, 15, 0.1), (e, r, g) -> e + g);
    rivals.add(same, effect, "absorption", sizes(-3, 8, 0.02), (e, r, a) -> e - 2 * a * r);
    rivals.add(
        same, effect, "early-timeout", sizes(0.2, 4, 0.01), (e, r, x) -> r < x ? e : SILENT_DB);
    return same;
  }

  private void listen(WaveEffect effect) {
    WaveWorld.Listening before = site.listening(List.of());
    WaveWorld.Listening after = site.listening(List.of(effect.alteration()));
    double[] distances = site.distancesM();
    for (int row = 0; row < distances.length; row++) {
      double was = before.excessDb(row);
      double is = after.excessDb(row);
      if (Math.max(was, is) > CONCERNED_DB) {
        rows.add(new double[] {was, chance(is), distances[row]});
      }
    }
  }

  private static double[] sizes(double from, double to, double step) {
    int count = (int) Math.round((to - from) / step) + 1;
    double[] sizes = new double[count];
    for (int i = 0; i < count; i++) {
      sizes[i] = from + i * step;
    }
    return sizes;
  }

  private void add(
      List<Set<String>> same, WaveEffect effect, String name, double[] sizes, Law law) {
    if (!effect.name().equals(name) && leastNats(sizes, law) <= SAME_NATS) {
      same.add(Set.of(name));
    }
  }

  /** The chance that an echo of a level over the threshold is heard: a logistic of its scatter. */
  private static double chance(double excessDb) {
    double heard = 1 / (1 + StrictMath.exp(-1.7 * excessDb / SCATTER_DB));
    return Math.max(LEAST_CHANCE, Math.min(1 - LEAST_CHANCE, heard));
  }

  /** The least expected log odds against the law, over its sizes (Kullback and Leibler 1951). */
  private double leastNats(double[] sizes, Law law) {
    double least = Double.POSITIVE_INFINITY;
    for (double size : sizes) {
      double sum = 0;
      for (double[] row : rows) {
        double so = row[1];
        double by = chance(law.excessDb(row[0], row[2], size));
        sum += so * StrictMath.log(so / by) + (1 - so) * StrictMath.log((1 - so) / (1 - by));
      }
      least = Math.min(least, sum);
    }
    return least;
  }
}
