package simbad.gap.unexplained;

import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.NearestRange;
import simbad.gap.fit.Placements;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.Geometry;

/**
 * Readings that an explanation takes for crosstalk. Crosstalk has nothing to do with the scene, so
 * its readings neither go with the distance of what stands there nor are alike at one place. That
 * is asked of things which were put in place, and not of crosstalk that walks from ping to ping: in
 * a drive distance and time go together, and so may another sonar's pings.
 *
 * <p>By Kendall's tau of pairs that could have been read the other way round (Tsai 1990), and by
 * how far readings at one distance lie apart. What is near its obstacle is no stray, and some
 * strays are always nearer than it: what chance gives is found by exchanging readings of such
 * pairs.
 */
final class Strays {
  /** A reading is one where it is so many times likelier with crosstalk than without, natural. */
  private static final double LIKELIER_NATS = 3;

  private static final int FEWEST = 12;
  private static final int MOST = 300;
  private static final int EXCHANGES = 20;
  private static final int LOGS = 199;

  /** One log in a hundred does so by chance, for each of the two. */
  private static final double CHANCE = 0.01;

  private static final double SAME_PLACE_M = 0.001;

  private final double[] rangeM;
  private final double[] distanceM;
  private final boolean areNearer;
  private final double apartM;

  private Strays(double[] rangeM, double[] distanceM) {
    this.rangeM = rangeM;
    this.distanceM = distanceM;
    areNearer = IntStream.range(0, rangeM.length).allMatch(i -> rangeM[i] < distanceM[i]);
    apartM =
        IntStream.range(0, rangeM.length)
            .mapToDouble(i -> Math.abs(rangeM[i] - distanceM[i]))
            .min()
            .orElse(0);
  }

  /** Finds the strays of a log under an explanation; none in one without crosstalk. */
  static Strays of(CalibratedLog given, Hypothesis best) {
    Optional<Effect> anywhere =
        best.forms().stream()
            .filter(f -> !Definitions.of(f.effect()).isOfThePlace(f.name()))
            .map(Form::effect)
            .findFirst();
    if (anywhere.isEmpty() || !new Placements(given.log()).areRepeated()) {
      return new Strays(new double[0], new double[0]);
    }
    Geometry geometry = given.geometry(given.model(best));
    double[] with = given.logLikelihood(best);
    double[] without = given.logLikelihood(best.without(anywhere.get()));
    int[] strays =
        IntStream.range(0, with.length)
            .filter(given.log()::echo)
            .filter(i -> !geometry.isEmpty(i) && with[i] - without[i] > LIKELIER_NATS)
            .toArray();
    int stride = Math.max(1, (strays.length + MOST - 1) / MOST);
    int[] some = IntStream.range(0, strays.length).filter(i -> i % stride == 0).toArray();
    return new Strays(
        IntStream.of(some).mapToDouble(i -> given.log().rangeM(strays[i])).toArray(),
        IntStream.of(some).mapToDouble(i -> NearestRange.inConeM(geometry, strays[i])).toArray());
  }

  /** Returns whether they depend on what stands there, as crosstalk does not. */
  boolean goWithDistance() {
    return rangeM.length >= FEWEST && chance() <= CHANCE;
  }

  /** What is wrong with taking them for crosstalk, in words. */
  String words() {
    return String.format(
        Locale.ROOT,
        "%d readings that fit nothing depend on the place, as crosstalk's would not",
        rangeM.length);
  }

  /** The lesser of the shares of logs of the same strays, exchanged, that go with it as much. */
  private double chance() {
    Random random = new Random(1);
    double[] own = rangeM.clone();
    long together = Math.abs(tau(own));
    double apart = apartAtOnePlaceM(own);
    int asMuch = 1;
    int asNear = 1;
    for (int log = 0; log < LOGS; log++) {
      for (int i = 0; i < EXCHANGES * own.length; i++) {
        exchange(own, random.nextInt(own.length), random.nextInt(own.length));
      }
      asMuch += Math.abs(tau(own)) >= together ? 1 : 0;
      asNear += apartAtOnePlaceM(own) <= apart ? 1 : 0;
    }
    return (double) Math.min(asMuch, asNear) / (LOGS + 1);
  }

  private void exchange(double[] own, int i, int j) {
    if (isPossible(own[i], distanceM[j]) && isPossible(own[j], distanceM[i])) {
      double kept = own[i];
      own[i] = own[j];
      own[j] = kept;
    }
  }

  private boolean isPossible(double range, double distance) {
    return areNearer ? range <= distance - apartM : Math.abs(range - distance) >= apartM;
  }

  /** Pairs that go together, less those that go apart. */
  private long tau(double[] own) {
    long sum = 0;
    for (int i = 0; i < own.length; i++) {
      for (int j = 0; j < i; j++) {
        if (isPossible(own[i], distanceM[j]) && isPossible(own[j], distanceM[i])) {
          sum += (long) (Math.signum(own[i] - own[j]) * Math.signum(distanceM[i] - distanceM[j]));
        }
      }
    }
    return sum;
  }

  /** The sum over pairs at one distance, metres. */
  private double apartAtOnePlaceM(double[] own) {
    double sum = 0;
    for (int i = 0; i < own.length; i++) {
      for (int j = 0; j < i; j++) {
        boolean same = Math.abs(distanceM[i] - distanceM[j]) < SAME_PLACE_M;
        sum += same ? Math.abs(own[i] - own[j]) : 0;
      }
    }
    return sum;
  }
}
