package simbad.gap.locate;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import simbad.gap.diagnosis.GapKind;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;

/**
 * Tells in what way simulation and reality part in a place.
 *
 * <p>An excess with no echo read is a missed one; with an echo read it is a phantom where none was
 * expected and an error of the range where one was, in proportion to how far it was.
 */
final class Kinds {
  private final PingLog log;
  private final List<ReadingDistribution> forecast;
  private final double[] excess;

  /**
   * Creates them.
   *
   * @param log what was read
   * @param forecast what the nominal model expects of each ping
   * @param excess of each ping's gap
   */
  Kinds(PingLog log, List<ReadingDistribution> forecast, double[] excess) {
    this.log = log;
    this.forecast = forecast;
    this.excess = excess;
  }

  /**
   * Returns the kind that carries most of the excess of some pings. Of the misses those that were
   * to be expected are taken away, and what they were expected to cost is given back to the echoes.
   */
  GapKind of(int[] pings) {
    double misses = 0;
    double expectedMisses = 0;
    double missed = 0;
    for (int ping : pings) {
      expectedMisses += forecast.get(ping).noEchoProbability();
      if (!log.echo(ping)) {
        misses++;
        missed += excess[ping];
      }
    }
    double each = misses > 0 ? missed / misses : 0;
    Map<GapKind, Double> carried = new EnumMap<>(GapKind.class);
    carried.put(GapKind.MISSED_ECHO, each * Math.max(0, misses - expectedMisses));
    for (int ping : pings) {
      if (log.echo(ping)) {
        double none = forecast.get(ping).noEchoProbability();
        carried.merge(GapKind.PHANTOM_ECHO, none * excess[ping], Double::sum);
        carried.merge(GapKind.RANGE_ERROR, (1 - none) * (excess[ping] + none * each), Double::sum);
      }
    }
    return carried.entrySet().stream()
        .max(Comparator.comparingDouble(Map.Entry::getValue))
        .map(Map.Entry::getKey)
        .orElse(GapKind.RANGE_ERROR);
  }
}
