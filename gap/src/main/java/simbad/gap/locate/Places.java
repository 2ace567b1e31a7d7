package simbad.gap.locate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.GapKind;
import simbad.gap.diagnosis.Place;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.BenjaminiHochberg;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapMeter;
import simbad.gap.slice.Slice;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.ChangedModel;

/**
 * Finds the places of a gap: the fewest slices of a log that hold what the nominal model's gap is
 * larger than it would be if that model were right. They are found on one half of the blocks, and
 * what is said of them is measured on the other.
 */
public final class Places {
  private static final int MOST = 8;
  private static final double FALSE_DISCOVERY_RATE = 0.1;

  /** A place with less of the excess is not worth a reader's time. */
  private static final double LEAST_SHARE = 0.02;

  /** As a share of what the gap would be: more rows make less significant, but not of any size. */
  private static final double LEAST_EXCESS = 0.05;

  /** By how much the mean excess of a place is above that of what is left beside it, at least. */
  private static final double STANDS_OUT = 1.25;

  /** What leaves out fewer rows, or a smaller share of them, is all of it. */
  private static final int LEAST_OUTSIDE = 15;

  private static final double LEAST_SHARE_OUTSIDE = 0.1;

  private final CalibratedLog given;
  private final GapMeter.Gaps before;
  private final GapMeter.Gaps after;
  private final Blocks blocks;
  private final Fold found;
  private final Fold confirmed;
  private final double[] excess;
  private final boolean[] covered;
  private final List<Candidate> looked = new ArrayList<>();

  private Places(CalibratedLog given, GapMeter.Gaps before, GapMeter.Gaps after, Blocks blocks) {
    this.given = given;
    this.before = before;
    this.after = after;
    this.blocks = blocks;
    found = blocks.half(0);
    confirmed = blocks.half(1);
    excess = new double[before.observedM().length];
    covered = new boolean[excess.length];
    for (int i = 0; i < excess.length; i++) {
      excess[i] = before.observedM()[i] - before.expectedM()[i];
    }
  }

  /**
   * A slice that was looked at in the confirming half.
   *
   * @param slice itself
   * @param chance of as large an excess where there is none
   * @param chosen whether it is part of the description
   * @param standsOut whether the excess is larger in it than beside it
   */
  private record Candidate(Slice slice, double chance, boolean chosen, boolean standsOut) {}

  /**
   * Looks for the places.
   *
   * @param given the log
   * @param before gaps under the nominal model
   * @param after gaps under the diagnosed model
   * @param blocks of the log
   */
  public static Places find(
      CalibratedLog given, GapMeter.Gaps before, GapMeter.Gaps after, Blocks blocks) {
    ChangedModel nominal = given.model(Hypothesis.NONE);
    Geometry geometry = given.geometry(nominal);
    Places places = new Places(given, before, after, blocks);
    if (given.log().size() > 0) {
      places.cover(Cuts.of(geometry));
    }
    return places;
  }

  /**
   * Returns at most 8, the largest share of the gap first; none where nothing is significant, or
   * where the gap is as large elsewhere.
   */
  public List<Place> thatStandOut() {
    return told(Candidate::standsOut);
  }

  /**
   * Returns the same and slices that hold all of the log, or in which it is as large as elsewhere.
   */
  public List<Place> anywhere() {
    return told(any -> true);
  }

  /** Greedily: the best slice of what no earlier one covers. */
  private void cover(List<Scan.Cut> cuts) {
    for (int round = 0; round < MOST; round++) {
      Scan scan = new Scan(excess, ping -> found.holds(ping) && !covered[ping]);
      List<Scan.Found> best =
          cuts.stream()
              .map(scan::best)
              .flatMap(Optional::stream)
              .filter(each -> mostlyOpen(each.slice()))
              .toList();
      Optional<Scan.Found> chosen =
          best.stream().reduce((one, other) -> other.merit() > one.merit() ? other : one);
      best.forEach(each -> looked.add(candidate(each, each.equals(chosen.orElseThrow()))));
      if (chosen.isEmpty() || open(chosen.get().slice(), found) < LEAST_SHARE * gap(found)) {
        return;
      }
      Slice slice = chosen.get().slice();
      IntStream.range(0, covered.length).filter(slice::holds).forEach(ping -> covered[ping] = true);
    }
  }

  /** A place that is mostly in others says little of its own. */
  private boolean mostlyOpen(Slice slice) {
    int open = 0;
    int rows = 0;
    for (int ping = 0; ping < covered.length; ping++) {
      if (found.holds(ping) && slice.holds(ping)) {
        rows++;
        open += covered[ping] ? 0 : 1;
      }
    }
    return 2 * open > rows;
  }

  private double open(Slice slice, Fold half) {
    return IntStream.range(0, excess.length)
        .filter(ping -> half.holds(ping) && !covered[ping] && slice.holds(ping))
        .mapToDouble(ping -> excess[ping])
        .sum();
  }

  private Candidate candidate(Scan.Found each, boolean chosen) {
    Slice slice = each.slice();
    double chance =
        Confirmation.chance(
            excess, blocks, ping -> confirmed.holds(ping) && !covered[ping] && slice.holds(ping));
    return new Candidate(slice, chance, chosen, standsOut(slice));
  }

  /**
   * Tells whether the excess is larger in a slice than in what no earlier one covers beside it, in
   * the confirming half. The last of several that hold all together has nothing left beside it.
   */
  private boolean standsOut(Slice slice) {
    int[] open =
        IntStream.range(0, excess.length)
            .filter(ping -> confirmed.holds(ping) && !covered[ping])
            .toArray();
    double in = meanExcess(IntStream.of(open).filter(slice::holds));
    IntStream beside = IntStream.of(open).filter(ping -> !slice.holds(ping));
    long all = IntStream.range(0, excess.length).filter(confirmed::holds).count();
    long outside = all - rows(slice).length;
    boolean leavesOut = outside >= Math.max(LEAST_OUTSIDE, LEAST_SHARE_OUTSIDE * all);
    return leavesOut && in > STANDS_OUT * meanExcess(beside);
  }

  /** Of no pings 0. */
  private double meanExcess(IntStream pings) {
    return pings.mapToDouble(ping -> excess[ping]).average().orElse(0);
  }

  private List<Place> told(Predicate<Candidate> which) {
    if (looked.isEmpty()) {
      return List.of();
    }
    List<ReadingDistribution> forecast = given.forecast(given.model(Hypothesis.NONE));
    double[] rate =
        BenjaminiHochberg.falseDiscoveryRates(looked.stream().map(Candidate::chance).toList());
    List<Place> places = new ArrayList<>();
    for (int i = 0; i < rate.length; i++) {
      Slice slice = looked.get(i).slice();
      boolean tells = looked.get(i).chosen() && which.test(looked.get(i));
      if (tells && rate[i] <= FALSE_DISCOVERY_RATE && matters(slice)) {
        GapKind kind = new Kinds(given.log(), forecast, excess).of(rows(slice));
        places.add(place(slice, kind, rate[i]));
      }
    }
    places.sort(Comparator.comparingDouble(Place::shareOfGap).reversed());
    return places;
  }

  private int[] rows(Slice slice) {
    return IntStream.range(0, excess.length)
        .filter(ping -> confirmed.holds(ping) && slice.holds(ping))
        .toArray();
  }

  private boolean matters(Slice slice) {
    int[] rows = rows(slice);
    double here = sum(excess, rows);
    return here > LEAST_EXCESS * sum(before.expectedM(), rows)
        && here > LEAST_SHARE * gap(confirmed);
  }

  private double gap(Fold half) {
    return IntStream.range(0, excess.length)
        .filter(half::holds)
        .mapToDouble(ping -> before.observedM()[ping])
        .sum();
  }

  private Place place(Slice slice, GapKind kind, double qValue) {
    int[] rows = rows(slice);
    double here = sum(before.observedM(), rows);
    return new Place(
        slice.conditions(),
        rows.length,
        here / gap(confirmed),
        100 * here / rows.length,
        100 * sum(after.observedM(), rows) / rows.length,
        kind,
        qValue);
  }

  private static double sum(double[] values, int[] rows) {
    return IntStream.of(rows).mapToDouble(ping -> values[ping]).sum();
  }
}
