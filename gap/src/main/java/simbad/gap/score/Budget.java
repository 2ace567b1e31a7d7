package simbad.gap.score;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import simbad.definition.Effect;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Refit;

/**
 * How the gap before is made up. An effect's share is what the gap grows by when it is left out,
 * averaged over the orders in which effects can be put in (Shapley 1953), on rows that its values
 * were not fitted on. What is left beyond the floor is the rest.
 */
public final class Budget {
  private static final int RESAMPLES = 1000;
  private static final int TAIL = 25;
  private static final int EVALUATIONS = 20;
  private static final double CM = 100;

  private final CalibratedLog given;
  private final Blocks blocks;
  private final Hypothesis explanation;

  /** By set of effects, a bit for each: the gap with them put in, summed over each block. */
  private final double[][] sums;

  private final double[] floorSums;
  private final int[] rows;

  private Budget(CalibratedLog given, Blocks blocks, Hypothesis explanation, GapGain gain) {
    this.given = given;
    this.blocks = blocks;
    this.explanation = explanation;
    sums = new double[1 << explanation.forms().size()][blocks.count()];
    floorSums = new double[blocks.count()];
    rows = new int[blocks.count()];
    for (int ping = 0; ping < given.log().size(); ping++) {
      rows[blocks.of(ping)]++;
    }
    add(gain.before().observedM(), Fold.ALL, sums[0]);
    add(gain.open().expectedM(), Fold.ALL, floorSums);
    if (sums.length > 1) {
      add(gain.after().observedM(), Fold.ALL, sums[sums.length - 1]);
    }
    if (sums.length > 2) {
      someOfThem();
    }
  }

  /**
   * Makes up a budget.
   *
   * @param given the log
   * @param blocks of the log
   * @param explanation the effects that are named, with their values
   * @param gain of the explanation
   * @param seed of the draws that the intervals come from
   * @return an entry for each effect in the explanation's order, the rest, the floor
   */
  public static List<BudgetEntry> of(
      CalibratedLog given, Blocks blocks, Hypothesis explanation, GapGain gain, long seed) {
    return new Budget(given, blocks, explanation, gain).entries(new Random(seed));
  }

  private void add(double[] gapsM, Fold fold, double[] into) {
    for (int ping = 0; ping < gapsM.length; ping++) {
      if (fold.holds(ping)) {
        into[blocks.of(ping)] += gapsM[ping];
      }
    }
  }

  /** All sets between none of the effects and all of them. */
  private void someOfThem() {
    GapMeter meter = new GapMeter(given);
    for (int part = 0; part < 2; part++) {
      Fold left = blocks.half(part);
      Hypothesis fitted = new Refit(given, ping -> !left.holds(ping)).of(explanation, EVALUATIONS);
      for (int set = 1; set < sums.length - 1; set++) {
        add(meter.measure(given, only(fitted, set)).observedM(), left, sums[set]);
      }
    }
  }

  private static Hypothesis only(Hypothesis all, int set) {
    Hypothesis some = all;
    for (int i = 0; i < all.forms().size(); i++) {
      some = contains(set, i) ? some : some.without(all.forms().get(i).effect());
    }
    return some;
  }

  private static boolean contains(int set, int effect) {
    return (set >> effect & 1) == 1;
  }

  private List<BudgetEntry> entries(Random random) {
    int[] each = new int[rows.length];
    Arrays.fill(each, 1);
    double[] whole = parts(each);
    double[][] drawn = new double[whole.length][RESAMPLES];
    for (int draw = 0; draw < RESAMPLES; draw++) {
      Arrays.fill(each, 0);
      for (int i = 0; i < each.length; i++) {
        each[random.nextInt(each.length)]++;
      }
      double[] parts = parts(each);
      for (int part = 0; part < parts.length; part++) {
        drawn[part][draw] = parts[part];
      }
    }
    List<String> names = new ArrayList<>();
    explanation.effects().stream().map(Effect::word).forEach(names::add);
    names.addAll(List.of(BudgetEntry.REST, BudgetEntry.FLOOR));
    List<BudgetEntry> entries = new ArrayList<>();
    for (int part = 0; part < whole.length; part++) {
      Arrays.sort(drawn[part]);
      Interval ci95 = new Interval(drawn[part][TAIL], drawn[part][RESAMPLES - 1 - TAIL]);
      entries.add(new BudgetEntry(names.get(part), whole[part], ci95));
    }
    return entries;
  }

  /** The effects' shares, the rest and the floor, in centimetres, of blocks taken so many times. */
  private double[] parts(int... times) {
    double[] gapCm = new double[sums.length];
    for (int set = 0; set < sums.length; set++) {
      gapCm[set] = meanCm(sums[set], times);
    }
    int effects = explanation.forms().size();
    double[] parts = new double[effects + 2];
    for (int effect = 0; effect < effects; effect++) {
      parts[effect] = share(effect, effects, gapCm);
    }
    double afterCm = gapCm[gapCm.length - 1];
    double floorCm = Math.min(afterCm, meanCm(floorSums, times));
    parts[effects] = afterCm - floorCm;
    parts[effects + 1] = floorCm;
    return parts;
  }

  private double meanCm(double[] blockSums, int... times) {
    double sum = 0;
    double count = 0;
    for (int block = 0; block < times.length; block++) {
      sum += times[block] * blockSums[block];
      count += (double) times[block] * rows[block];
    }
    return count > 0 ? CM * sum / count : 0;
  }

  /** What an effect takes away, averaged over all orders of putting effects in. */
  private static double share(int effect, int effects, double... gapCm) {
    double share = 0;
    for (int set = 0; set < gapCm.length; set++) {
      if (!contains(set, effect)) {
        int before = Integer.bitCount(set);
        double orders = factorial(before) * factorial(effects - before - 1) / factorial(effects);
        share += orders * (gapCm[set] - gapCm[set | 1 << effect]);
      }
    }
    return share;
  }

  private static double factorial(int n) {
    return n <= 1 ? 1 : n * factorial(n - 1);
  }
}
