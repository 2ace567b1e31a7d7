package simbad.gap.fit;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.sonar.effect.DiagnosedModel;
import simbad.sonar.effect.Geometry;
import simbad.sonar.effect.PingLog;
import simbad.sonar.scene.SensingSetup;

/** What a hypothesis leaves over: readings that it thinks hardly possible, echoes it misses. */
final class Clues {
  /** A reading with less than this is one that the hypothesis does not explain, log probability. */
  private static final double STRANGE = Math.log(1e-3);

  final PingLog log;
  final Geometry geometry;
  private final double[] logLikelihood;
  private final double[] nearest;
  private final SensingSetup setup;
  private final Fold fold;

  Clues(Evidence evidence, Hypothesis hypothesis) {
    this(evidence, hypothesis, Fold.ALL);
  }

  Clues(Evidence evidence, Hypothesis hypothesis, Fold fold) {
    this.fold = fold;
    log = evidence.log();
    setup = evidence.setup();
    DiagnosedModel model = evidence.model(hypothesis);
    geometry = evidence.geometry(model);
    logLikelihood = new double[log.size()];
    evidence.logLikelihood(model, geometry, logLikelihood);
    nearest = new double[log.size()];
    for (int ping = 0; ping < nearest.length; ping++) {
      nearest[ping] = Double.POSITIVE_INFINITY;
      for (int o = 0; o < geometry.obstacles(); o++) {
        nearest[ping] = Math.min(nearest[ping], geometry.nearestM(ping * geometry.obstacles() + o));
      }
    }
  }

  /** Pings that count and have an obstacle in the cone. */
  IntStream inCone(int obstacle) {
    return IntStream.range(0, log.size())
        .filter(fold::holds)
        .filter(
            ping ->
                geometry.nearestM(ping * geometry.obstacles() + obstacle)
                    < Double.POSITIVE_INFINITY);
  }

  /** Softness of the threshold as believed, metres. */
  double edgeWidthM() {
    return setup.sensor().edgeWidthM();
  }

  /** The set-up as the simulator believes it. */
  SensingSetup setup() {
    return setup;
  }

  /** Echoes that the hypothesis cannot explain. */
  IntStream strangeEchoes() {
    return IntStream.range(0, log.size())
        .filter(ping -> log.echo(ping) && logLikelihood[ping] < STRANGE);
  }

  /** Echoes of pings that have an obstacle in the cone. */
  IntStream echoesInCone() {
    return IntStream.range(0, log.size())
        .filter(ping -> log.echo(ping) && nearest[ping] < Double.POSITIVE_INFINITY);
  }

  /** Distance to the nearest obstacle in the cone, metres; infinity for none. */
  double nearestM(int ping) {
    return nearest[ping];
  }

  /** Distances of obstacles that are near enough to answer. */
  DoubleStream audibleM() {
    return IntStream.range(0, log.size() * geometry.obstacles())
        .filter(
            line ->
                geometry.nearestM(line) < Double.POSITIVE_INFINITY
                    && geometry.centreDistanceM(line) < geometry.thresholdM(line))
        .mapToDouble(geometry::nearestM);
  }

  /** The reading before, of a ping that has one. */
  boolean hasEchoBefore(int ping) {
    return ping > log.sequenceStart(ping) && log.echo(ping - 1);
  }
}
