package simbad.sonar.effect;

import org.jspecify.annotations.Nullable;

/**
 * How probable each reading is, given the readings before it: a filter over what was not read, the
 * state of a burst and how often a reading was already repeated.
 */
final class Likelihood {
  private final DiagnosedModel model;
  private final Geometry geometry;
  private final PingLog log;
  private final PingModel pings;
  private final @Nullable Burst burst;
  private final @Nullable StaleReading stale;
  private final Mixture clear = new Mixture();
  private final Mixture silenced = new Mixture();
  private final Mixture before = new Mixture();
  private final HoldState hold = new HoldState();
  private double inBurst;
  private double heard;

  Likelihood(DiagnosedModel model, Geometry geometry) {
    this.model = model;
    this.geometry = geometry;
    log = geometry.log();
    pings = model.pings(geometry);
    burst = PingModel.of(Burst.class, model.changes()).stream().findFirst().orElse(null);
    stale = PingModel.of(StaleReading.class, model.changes()).stream().findFirst().orElse(null);
  }

  void into(double[] probability) {
    for (int ping = 0; ping < geometry.log().size(); ping++) {
      if (log.sequenceStart(ping) == ping) {
        start();
      } else {
        remember(ping - 1);
      }
      probability[ping] = step(ping);
    }
  }

  private void start() {
    before.clear();
    heard = 0;
    hold.start();
    inBurst = burst == null ? 0 : burst.share();
  }

  private void remember(int previous) {
    before.clear();
    if (log.echo(previous)) {
      before.add(log.rangeM(previous), 0, 1);
    }
  }

  private double step(int ping) {
    pings.mix(ping, heard, before, 0, clear);
    if (burst == null && stale == null) {
      heard = log.echo(ping) ? 1 : 0;
      return log.echo(ping) ? within(clear, ping) : silence(clear);
    }
    if (burst != null && log.sequenceStart(ping) != ping) {
      inBurst = burst.next(inBurst);
    }
    return filter(ping);
  }

  private double filter(int ping) {
    double echo = within(clear, ping);
    double silent = silence(clear);
    double burstEcho = 0;
    double burstSilent = 0;
    if (burst != null) {
      pings.mix(ping, heard, before, burst.depth(), silenced);
      burstEcho = within(silenced, ping);
      burstSilent = silence(silenced);
    }
    double real = (1 - inBurst) * echo + inBurst * burstEcho;
    double miss = (1 - inBurst) * silent + inBurst * burstSilent;
    double repeated = repeats(ping);
    double total = log.echo(ping) ? real + miss * repeated : miss * (1 - repeated);
    if (!(total > 0)) {
      // Impossible under this model: what is hidden stays as it was expected to be.
      hold.start();
      heard = log.echo(ping) ? 1 : 0;
      return 0;
    }
    if (burst != null) {
      double within =
          log.echo(ping) ? burstEcho + burstSilent * repeated : burstSilent * (1 - repeated);
      inBurst *= within / total;
    }
    heard = log.echo(ping) ? real / total : 0;
    update(ping, real / total, repeated);
    return total;
  }

  /** How probable it is that a miss at this ping shows the last reading once more. */
  private double repeats(int ping) {
    if (stale == null || before.size() == 0) {
      return 0;
    }
    if (log.echo(ping) && log.rangeM(ping) != before.meanM(0)) {
      return 0;
    }
    return hold.repeats(stale, log, ping);
  }

  private void update(int ping, double real, double repeated) {
    if (stale == null) {
      return;
    }
    if (log.echo(ping)) {
      hold.advance(stale, log, ping, real, repeated > 0 ? (1 - real) / repeated : 0);
    } else {
      hold.start();
    }
  }

  private double within(Mixture mixture, int ping) {
    if (!log.echo(ping)) {
      return 0;
    }
    double range = log.rangeM(ping);
    return mixture.within(model.stepStartM(range), model.stepEndM(range));
  }

  private static double silence(Mixture mixture) {
    return Math.max(0, 1 - mixture.echoShare());
  }
}
