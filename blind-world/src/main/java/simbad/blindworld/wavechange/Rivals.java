package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import simbad.blindworld.wave.WaveWorld;

/**
 * Which of gain, absorption and early-timeout lose the same echoes as a change does, row by row: by
 * levels over the threshold without noise, with the best size of each. What differs on fewer rows
 * than one in 200 no data of this size could tell.
 */
final class Rivals {

  private static final double SAME = 0.005;

  /** Rows further under the threshold in both worlds say nothing. */
  private static final double CONCERNED_DB = -6;

  private final Site site;
  private final List<double[]> rows = new ArrayList<>();

  private Rivals(Site site) {
    this.site = site;
  }

  /** A size of a law: whether a row is heard by it. */
  private interface Law {
    boolean hears(double excessDb, double distanceM, double size);
  }

  /** Names whose law loses the same echoes as the effect; its own name is not among them. */
  static List<Set<String>> of(WaveEffect effect, Site site) {
    Rivals rivals = new Rivals(site);
    rivals.listen(effect);
    List<Set<String>> same = new ArrayList<>();
    rivals.add(same, effect, "gain", sizes(-20, 15, 0.1), (e, r, g) -> e + g > 0);
    rivals.add(same, effect, "absorption", sizes(-3, 8, 0.02), (e, r, a) -> e - 2 * a * r > 0);
    rivals.add(same, effect, "early-timeout", sizes(0.2, 4, 0.01), (e, r, x) -> e > 0 && r < x);
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
        rows.add(new double[] {was, is > 0 ? 1 : 0, distances[row]});
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
    if (!effect.name().equals(name) && leastDifference(sizes, law) <= SAME * rows.size()) {
      same.add(Set.of(name));
    }
  }

  private int leastDifference(double[] sizes, Law law) {
    int least = Integer.MAX_VALUE;
    for (double size : sizes) {
      int differ = 0;
      for (double[] row : rows) {
        differ += law.hears(row[0], row[2], size) == row[1] > 0 ? 0 : 1;
      }
      least = Math.min(least, differ);
    }
    return least;
  }
}
