package simbad.sonar.effect;

/**
 * How probable each reading is, given the readings before it: a filter over what is not read, the
 * state of a burst and how often a reading was already repeated.
 */
final class Likelihood {
  private final DiagnosedModel model;
  private final PingLog log;
  private final PingModel pings;
  private final Memory memory;
  private final Mixture mixture = new Mixture();
  private final Mixture before = new Mixture();
  private final double[][] echo = new double[2][2];
  private final double[][] silent = new double[2][2];
  private HiddenState state = new HiddenState();
  private HiddenState next = new HiddenState();

  Likelihood(DiagnosedModel model, Geometry geometry) {
    this.model = model;
    log = geometry.log();
    pings = model.pings(geometry);
    memory = model.memory();
  }

  void into(double[] probability) {
    for (int ping = 0; ping < log.size(); ping++) {
      boolean first = log.sequenceStart(ping) == ping;
      before.clear();
      if (!first && log.echo(ping - 1)) {
        before.add(log.rangeM(ping - 1), 0, 1);
      }
      probability[ping] = memory.isSeen() ? seen(ping) : filtered(ping, first);
    }
  }

  private double seen(int ping) {
    pings.mix(ping, before.size() > 0, before, 0, mixture);
    return log.echo(ping) ? within(ping) : silence();
  }

  private double filtered(int ping, boolean first) {
    if (first) {
      state.start(memory.burstShare());
    } else if (memory.burst() != null) {
      state.pass(memory.burst());
    }
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      for (int heard = 0; heard < 2; heard++) {
        expect(ping, inBurst, heard);
      }
    }
    next.clear();
    double total = 0;
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      for (int slot = 0; slot < state.slots(); slot++) {
        total += advance(ping, inBurst, slot);
      }
    }
    if (total > 0) {
      next.divide(total);
    } else {
      // Impossible under this model: what is hidden stays as it was expected to be.
      next.clear();
      next.add(0, log.echo(ping) ? HiddenState.ECHO : 0, 1 - state.inBurst());
      next.add(1, log.echo(ping) ? HiddenState.ECHO : 0, state.inBurst());
    }
    HiddenState spent = state;
    state = next;
    next = spent;
    return total;
  }

  private void expect(int ping, int inBurst, int heard) {
    if (inBurst == 1 && memory.burst() == null) {
      return;
    }
    if (heard == 1 && memory.hysteresis() == null) {
      echo[inBurst][1] = echo[inBurst][0];
      silent[inBurst][1] = silent[inBurst][0];
      return;
    }
    pings.mix(ping, heard == 1, before, memory.lost(inBurst), mixture);
    echo[inBurst][heard] = log.echo(ping) ? within(ping) : 0;
    silent[inBurst][heard] = silence();
  }

  /** Moves the probability of a state on to the states that explain the reading. */
  private double advance(int ping, int inBurst, int slot) {
    double probability = state.get(inBurst, slot);
    if (probability == 0) {
      return 0;
    }
    int heard = slot == HiddenState.ECHO ? 1 : 0;
    double missed = probability * silent[inBurst][heard];
    double repeats = slot == 0 ? 0 : memory.repeats(slot, log.timeS(ping) - log.timeS(ping - slot));
    if (!log.echo(ping)) {
      next.add(inBurst, 0, missed * (1 - repeats));
      return missed * (1 - repeats);
    }
    double real = probability * echo[inBurst][heard];
    next.add(inBurst, HiddenState.ECHO, real);
    if (repeats > 0 && log.rangeM(ping) == log.rangeM(ping - 1)) {
      next.add(inBurst, slot + 1, missed * repeats);
      return real + missed * repeats;
    }
    return real;
  }

  private double within(int ping) {
    double range = log.rangeM(ping);
    return mixture.within(model.stepStartM(range), model.stepEndM(range));
  }

  private double silence() {
    return Math.max(0, 1 - mixture.echoShare());
  }
}
