package simbad.sonar.catalogue;

import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;

/** Where a gate may begin or end: at distances that obstacles had. */
final class Distances {
  private static final int QUANTILES = 20;

  /** So far an echo is from what it is of: where things were placed, and the air's warmth. */
  private static final double PLACE_M = 0.05;

  private static final double AIR = 0.07;

  private Distances() {}

  /** The tries of a form whose first parameter is a distance, which takes those of the log. */
  static List<List<Double>> first(Form form, Clues clues) {
    List<List<Double>> tries = Tries.of(form);
    double[] sorted = clues.audibleM().sorted().toArray();
    if (sorted.length > 0) {
      tries.set(
          0,
          IntStream.rangeClosed(1, QUANTILES)
              .mapToObj(i -> Modes.quantile(sorted, (double) i / (QUANTILES + 1)))
              .toList());
    }
    return tries;
  }

  /**
   * The distances from which on a log hears less, best first: where no echo comes, and where none
   * comes of what stands there. A number for no echo hides the first, ranges that begin again the
   * second.
   */
  static List<Double> edges(Clues clues) {
    PingLog log = clues.log();
    return Stream.<IntPredicate>of(log::echo, ping -> log.echo(ping) && isOfNearest(clues, ping))
        .map(heard -> edge(clues, heard))
        .filter(OptionalDouble::isPresent)
        .map(OptionalDouble::getAsDouble)
        .distinct()
        .toList();
  }

  private static boolean isOfNearest(Clues clues, int ping) {
    double nearest = clues.nearestM(ping);
    return Math.abs(clues.log().rangeM(ping) - nearest) <= PLACE_M + AIR * nearest;
  }

  /** The cut that leaves most of what is heard before it and of what is not beyond. */
  private static OptionalDouble edge(Clues clues, IntPredicate heard) {
    int[] pings =
        IntStream.range(0, clues.log().size())
            .filter(ping -> clues.nearestM(ping) < Double.POSITIVE_INFINITY)
            .boxed()
            .sorted(Comparator.comparingDouble(clues::nearestM))
            .mapToInt(Integer::intValue)
            .toArray();
    int score = 0;
    int best = 0;
    OptionalDouble edge = OptionalDouble.empty();
    // From the far end: what is lost beyond the cut counts for it, what is heard against it.
    for (int at = pings.length - 1; at > 0; at--) {
      score += heard.test(pings[at]) ? -1 : 1;
      double near = clues.nearestM(pings[at - 1]);
      double far = clues.nearestM(pings[at]);
      if (score > best && far > near) {
        best = score;
        edge = OptionalDouble.of((near + far) / 2);
      }
    }
    return edge;
  }
}
