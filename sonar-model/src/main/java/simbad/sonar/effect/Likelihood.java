package simbad.sonar.effect;

import org.jspecify.annotations.Nullable;

/**
 * How probable each reading is, given the readings before it: a filter over what was not read, the
 * state of a burst and how often a reading was already repeated.
 */
final class Likelihood {
  /** A reading that no part explains came from where it says. */
  private static final double LEAST_EXPLAINED = 1e-9;

  private static final double LEAST_SHARE = 0.01;

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
    for (int ping = 0; ping < log.size(); ping++) {
      begin(ping);
      probability[ping] = step(ping);
    }
  }

  void into(Expectation expectation) {
    for (int ping = 0; ping < log.size(); ping++) {
      begin(ping);
      expect(ping, expectation);
      expectation.reading()[ping] = step(ping);
    }
  }

  private void begin(int ping) {
    if (log.sequenceStart(ping) == ping) {
      start();
    } else if (pings.remembersReading()) {
      remember(ping - 1);
    }
  }

  /** The same as a step, but before the reading is known. */
  private void expect(int ping, Expectation expectation) {
    pings.mix(ping, heard, before, 0, clear);
    double burstNow = burst == null ? 0 : inBurst;
    if (burst != null && log.sequenceStart(ping) != ping) {
      burstNow = burst.next(inBurst);
    }
    double real = (1 - burstNow) * clear.echoShare();
    double below = (1 - burstNow) * below(clear, ping);
    double miss = (1 - burstNow) * silence(clear);
    if (burst != null) {
      pings.mix(ping, heard, before, burst.depth(), silenced);
      real += burstNow * silenced.echoShare();
      below += burstNow * below(silenced, ping);
      miss += burstNow * silence(silenced);
    }
    double held = canRepeat(ping) ? miss * hold.repeats(requireStale(), log, ping) : 0;
    boolean heldBelow =
        held > 0 && model.stepEndM(log.rangeM(ping - 1)) <= model.stepStartM(log.rangeM(ping));
    expectation.echo()[ping] = Math.min(1, real + held);
    expectation.below()[ping] = below + (heldBelow ? held : 0);
  }

  private StaleReading requireStale() {
    return java.util.Objects.requireNonNull(stale);
  }

  private double below(Mixture mixture, int ping) {
    return log.echo(ping)
        ? mixture.within(Double.NEGATIVE_INFINITY, model.stepStartM(log.rangeM(ping)))
        : 0;
  }

  private void start() {
    before.clear();
    heard = 0;
    hold.start();
    inBurst = burst == null ? 0 : burst.share();
  }

  /** What the reading before may have come from, by how well each part explains it. */
  private void remember(int previous) {
    before.clear();
    if (!log.echo(previous)) {
      return;
    }
    double low = model.stepStartM(log.rangeM(previous));
    double high = model.stepEndM(log.rangeM(previous));
    double total = clear.within(low, high);
    if (!(total > LEAST_EXPLAINED)) {
      before.add(log.rangeM(previous), 0, 1);
      return;
    }
    for (int part = 0; part < clear.size(); part++) {
      double share = clear.within(part, low, high) / total;
      if (share > LEAST_SHARE) {
        boolean known = clear.halfWidthM(part) == 0;
        before.add(known ? clear.meanM(part) : log.rangeM(previous), 0, share);
      }
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
    if (!canRepeat(ping) || log.echo(ping) && log.rangeM(ping) != log.rangeM(ping - 1)) {
      return 0;
    }
    return hold.repeats(requireStale(), log, ping);
  }

  private boolean canRepeat(int ping) {
    return stale != null && ping > log.sequenceStart(ping) && log.echo(ping - 1);
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
