package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.sonar.model.ReadingDistribution;

/** What is expected of each ping when no reading is known: memory runs forward by probabilities. */
final class Forecast {
  private static final double FOLLOWED = 0.01;
  private static final double HARDLY = 1e-4;

  private final DiagnosedModel model;
  private final PingLog log;
  private final PingModel pings;
  private final double burstLoss;
  private final @Nullable StaleReading stale;
  private final HoldState hold = new HoldState();

  /** What the last pings may have read for themselves, newest first. */
  private final List<Mixture> own = new ArrayList<>();

  private Mixture before = new Mixture();
  private double heard;

  Forecast(DiagnosedModel model, Geometry geometry) {
    this.model = model;
    log = geometry.log();
    pings = model.pings(geometry);
    burstLoss =
        PingModel.of(Burst.class, model.changes()).stream()
            .mapToDouble(burst -> burst.share() * burst.depth())
            .findFirst()
            .orElse(0);
    stale = PingModel.of(StaleReading.class, model.changes()).stream().findFirst().orElse(null);
  }

  List<ReadingDistribution> all() {
    List<ReadingDistribution> all = new ArrayList<>(log.size());
    for (int ping = 0; ping < log.size(); ping++) {
      if (log.sequenceStart(ping) == ping) {
        start();
      }
      all.add(model.distribution(step(ping)));
    }
    return all;
  }

  private void start() {
    before = new Mixture();
    heard = 0;
    hold.start();
    own.clear();
  }

  private Mixture step(int ping) {
    Mixture mixture = new Mixture();
    pings.mix(ping, heard, before, burstLoss, mixture);
    heard = mixture.echoShare();
    Mixture read = stale == null ? mixture : repeat(stale, ping, mixture);
    // Echoes of echoes of echoes would fill any memory: what hardly ever happens is not followed.
    before = new Mixture();
    before.addGreater(read, FOLLOWED);
    return read;
  }

  /** Adds the readings of earlier pings that are repeated if this one is missed. */
  private Mixture repeat(StaleReading held, int ping, Mixture mixture) {
    double miss = Math.max(0, 1 - mixture.echoShare());
    Mixture read = new Mixture();
    read.addAll(mixture, 1);
    for (int times = 0; times <= hold.last(); times++) {
      double share = hold.probability(times) * held.holds(log, ping, times) * miss;
      Mixture source = own.get(times);
      if (share > HARDLY && source.echoShare() > 0) {
        read.addAll(source, share / source.echoShare());
      }
    }
    hold.advance(held, log, ping, mixture.echoShare(), miss);
    own.add(0, mixture);
    if (own.size() > HoldState.MOST + 1) {
      own.remove(HoldState.MOST + 1);
    }
    return read;
  }
}
