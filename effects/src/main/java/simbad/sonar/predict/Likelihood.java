package simbad.sonar.predict;

import org.jspecify.annotations.Nullable;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.PingLog;

/**
 * How probable each reading is, given the readings before it: a hidden-state filter (the forward
 * algorithm of a hidden Markov model) over what is not read, the state of a burst, how often a
 * reading was already repeated, and where it came from.
 */
final class Likelihood {
  /** A reading that no part explains came from where it says. */
  private static final double LEAST_EXPLAINED = 1e-9;

  private static final double LEAST_SHARE = 0.01;

  /** Of so many parts at most, the likeliest, a reading may have come. */
  private static final int SOURCES = 4;

  private final ChangedModel model;
  private final PingLog log;
  private final PingModel pings;
  private final Memory memory;
  private final Mixture mixture = new Mixture();
  private final Mixture one = new Mixture();
  private final Mixture part = new Mixture();

  /** What the ping may read, over all states. */
  private final Mixture all = new Mixture();

  /** What the reading before may have come from. */
  private final Mixture before = new Mixture();

  // By the state of the burst, and whether the ping before was answered.
  private final double[][] echo = new double[2][2];
  private final double[][] silent = new double[2][2];
  private final double[][] below = new double[2][2];

  /** By the state of the burst: of a ping with nothing in its cone; below 0 until it is known. */
  private final double[] emptySilent = {-1, -1};

  private final boolean emptyOnesAreAlike;

  /** Whether a burst takes the same share of all that may be read. */
  private final boolean losesAlike;

  /** How probable an echo was of the ping that was mixed last. */
  private double mixed;

  /** The step that was read last. */
  private double stepStartM;

  private double stepEndM;

  /** Whether it is asked how probable a nearer echo was. */
  private boolean telling;

  private HiddenState state = new HiddenState();
  private HiddenState next = new HiddenState();

  Likelihood(ChangedModel model, Geometry geometry, Answers known) {
    this.model = model;
    log = geometry.log();
    pings = model.pings(geometry, known);
    memory = model.memory();
    emptyOnesAreAlike = pings.emptyOnesAreAlike();
    losesAlike = pings.onlyRanges() && memory.hysteresis() == null;
  }

  /**
   * Computes probabilities.
   *
   * @param probability takes that of what was read
   * @param echoes takes that of any echo where one was read; null if it is not asked for
   * @param only which pings are asked for, null for all; others need not be computed
   */
  void into(double[] probability, double @Nullable [] echoes, boolean @Nullable [] only) {
    boolean alike = memory.burst() == null && emptyOnesAreAlike;
    double empty = -1;
    double told = 0;
    for (int ping = 0; ping < log.size(); ping++) {
      boolean known = alike && isUneventful(ping);
      // The first empty one speaks for all; where something is remembered all of them matter.
      boolean isNeeded = only == null || only[ping] || !memory.isNone() || (known && empty < 0);
      if (!isNeeded) {
        continue;
      }
      if (known && empty >= 0) {
        // Most pings of most logs: nothing in the cone, nothing read, nothing to remember.
        probability[ping] = empty;
        restart(ping);
      } else if (memory.isNone()) {
        probability[ping] = alone(ping);
        told = mixture.echoShare();
      } else {
        expect(ping);
        told = echoes == null ? 0 : heard(ping);
        probability[ping] = learn(ping);
      }
      if (echoes != null) {
        echoes[ping] = told;
      }
      empty = known ? probability[ping] : empty;
    }
  }

  /** Whether a ping has nothing in its cone and no echo, and so has the one before. */
  private boolean isUneventful(int ping) {
    return !log.echo(ping)
        && pings.geometry().isEmpty(ping)
        && (memory.isNone() || log.sequenceStart(ping) == ping || !log.echo(ping - 1));
  }

  private void restart(int ping) {
    if (log.sequenceStart(ping) == ping) {
      before.clear();
      state.start(0);
    }
  }

  /** Of a ping that depends on no other. */
  private double alone(int ping) {
    boolean echo = log.echo(ping);
    pings.arrive(ping, false, Mixture.EMPTY, echo);
    pings.mix(0, echo, mixture);
    if (!echo) {
      return Math.max(0, 1 - mixture.echoShare());
    }
    double range = log.rangeM(ping);
    return mixture.within(model.stepStartM(range), model.stepEndM(range));
  }

  void into(Expectation expectation) {
    telling = true;
    for (int ping = 0; ping < log.size(); ping++) {
      expect(ping);
      tell(ping, expectation);
      expectation.reading()[ping] = learn(ping);
    }
  }

  private void expect(int ping) {
    if (log.sequenceStart(ping) == ping) {
      before.clear();
      state.start(memory.burstShare());
    } else {
      if (memory.ghosts() || memory.hysteresis() != null) {
        remember(ping - 1);
      }
      if (memory.burst() != null) {
        state.pass(memory.burst());
      }
    }
    if (log.echo(ping)) {
      stepStartM = model.stepStartM(log.rangeM(ping));
      stepEndM = model.stepEndM(log.rangeM(ping));
    }
    all.clear();
    int bursts = memory.burst() == null ? 1 : 2;
    for (int inBurst = 0; inBurst < bursts; inBurst++) {
      expect(ping, inBurst, 0);
      if (memory.hysteresis() != null) {
        expect(ping, inBurst, 1);
      }
    }
  }

  private void expect(int ping, int inBurst, int heard) {
    boolean known = emptyOnesAreAlike && pings.onlyRanges() && isUneventful(ping);
    if (known && emptySilent[inBurst] >= 0) {
      silent[inBurst][heard] = emptySilent[inBurst];
      return;
    }
    if (inBurst == 1 && losesAlike) {
      lose(heard);
    } else {
      read(ping, inBurst, heard);
    }
    if (known) {
      emptySilent[inBurst] = silent[inBurst][heard];
    }
  }

  private void read(int ping, int inBurst, int heard) {
    mix(ping, inBurst, heard == 1);
    mixed = mixture.echoShare();
    silent[inBurst][heard] = Math.max(0, 1 - mixed);
    if (log.echo(ping)) {
      echo[inBurst][heard] = mixture.within(stepStartM, stepEndM);
      if (telling) {
        below[inBurst][heard] = mixture.within(Double.NEGATIVE_INFINITY, stepStartM);
      }
    }
    if (memory.ghosts() && !memory.asRead() && log.echo(ping)) {
      all.merge(mixture, weight(inBurst, heard), 0);
    }
  }

  /** In a burst a ping reads what it reads outside, less often. */
  private void lose(int heard) {
    double kept = 1 - memory.lost(1);
    silent[1][heard] = Math.max(0, 1 - kept * mixed);
    echo[1][heard] = kept * echo[0][heard];
    below[1][heard] = kept * below[0][heard];
  }

  /** How probable the states are that a mixture stands for. */
  private double weight(int inBurst, int heard) {
    double echoed = state.get(inBurst, HiddenState.ECHO);
    double every = state.sum(inBurst);
    if (memory.hysteresis() == null) {
      return every;
    }
    return heard == 1 ? echoed : every - echoed;
  }

  /** Mixes what a ping may read, over all that the reading before may have come from. */
  private void mix(int ping, int inBurst, boolean heard) {
    double lost = memory.lost(inBurst);
    if (before.size() < 2) {
      boolean echo = log.echo(ping);
      // What arrives is the same in a burst, where some of it is lost.
      if (inBurst == 0 || memory.hysteresis() != null) {
        pings.arrive(ping, heard, before, echo);
      }
      pings.mix(lost, echo, mixture);
      return;
    }
    mixture.clear();
    for (int source = 0; source < before.size(); source++) {
      one.clear();
      one.add(before.meanM(source), 0, 1);
      pings.mix(ping, heard, one, lost, part);
      mixture.merge(part, before.share(source), 0);
    }
  }

  /** What the reading before may have come from, by how well each part explains it. */
  private void remember(int previous) {
    boolean again = log.echo(previous) && before.size() > 0 && repeatsReading(previous);
    if (!log.echo(previous)) {
      before.clear();
      return;
    }
    if (memory.asRead() || !memory.ghosts()) {
      before.clear();
      before.add(log.rangeM(previous), 0, 1);
      return;
    }
    double total = explain();
    if (!(total > LEAST_EXPLAINED)) {
      if (!again) {
        before.clear();
        before.add(log.rangeM(previous), 0, 1);
      }
      return;
    }
    double least = Math.max(LEAST_SHARE, one.shareOfRank(SOURCES) / total);
    before.clear();
    for (int i = 0; i < all.size(); i++) {
      double share = one.share(i) / total;
      if (share > least) {
        boolean known = all.halfWidthM(i) == 0;
        before.add(known ? all.meanM(i) : log.rangeM(previous), 0, share);
      }
    }
    before.scaleShares(1 / before.echoShare());
  }

  /** Puts how well each part explains the last reading where there is room; returns the sum. */
  private double explain() {
    one.clear();
    double total = 0;
    for (int i = 0; i < all.size(); i++) {
      double share = all.within(i, stepStartM, stepEndM);
      one.add(0, 0, share);
      total += share;
    }
    return total;
  }

  private boolean repeatsReading(int ping) {
    return memory.stale() != null
        && log.sequenceStart(ping) != ping
        && log.echo(ping - 1)
        && log.rangeM(ping - 1) == log.rangeM(ping);
  }

  /** The probability of an echo, over all states. */
  private double heard(int ping) {
    double heard = 0;
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      for (int slot = 0; slot < state.slots(); slot++) {
        double probability = state.get(inBurst, slot);
        if (probability > 0) {
          double missed = silent[inBurst][answered(slot)];
          heard += probability * (1 - missed + missed * repeats(ping, slot));
        }
      }
    }
    return Math.min(1, heard);
  }

  private void tell(int ping, Expectation expectation) {
    double heard = 0;
    double nearer = 0;
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      for (int slot = 0; slot < state.slots(); slot++) {
        double probability = state.get(inBurst, slot);
        if (probability > 0) {
          int answered = answered(slot);
          double repeated = silent[inBurst][answered] * repeats(ping, slot);
          heard += probability * (1 - silent[inBurst][answered] + repeated);
          if (log.echo(ping)) {
            nearer += probability * below[inBurst][answered];
            nearer += probability * (repeated > 0 && isBelow(ping - 1, ping) ? repeated : 0);
          }
        }
      }
    }
    expectation.echo()[ping] = Math.min(1, heard);
    expectation.below()[ping] = nearer;
  }

  /** Whether one ping's reading lies in a nearer step than another one's. */
  private boolean isBelow(int ping, int other) {
    return model.stepEndM(log.rangeM(ping)) <= model.stepStartM(log.rangeM(other));
  }

  private int answered(int slot) {
    return slot == HiddenState.ECHO && memory.hysteresis() != null ? 1 : 0;
  }

  private double repeats(int ping, int slot) {
    return slot == 0 ? 0 : memory.repeats(slot, log.timeS(ping) - log.timeS(ping - slot));
  }

  /** Moves the states on to those that explain the reading; returns its probability. */
  private double learn(int ping) {
    next.clear();
    double total = 0;
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      for (int slot = 0; slot < state.slots(); slot++) {
        if (state.get(inBurst, slot) > 0) {
          total += learn(ping, inBurst, slot);
        }
      }
    }
    if (total > 0) {
      next.divide(total);
    } else {
      // Impossible under this model: what is hidden stays as it was expected to be.
      next.clear();
      double inBurst = state.sum(1);
      next.add(0, log.echo(ping) ? HiddenState.ECHO : 0, 1 - inBurst);
      next.add(1, log.echo(ping) ? HiddenState.ECHO : 0, inBurst);
    }
    HiddenState spent = state;
    state = next;
    next = spent;
    return total;
  }

  private double learn(int ping, int inBurst, int slot) {
    double probability = state.get(inBurst, slot);
    double missed = probability * silent[inBurst][answered(slot)];
    double repeats = repeats(ping, slot);
    if (!log.echo(ping)) {
      next.add(inBurst, 0, missed * (1 - repeats));
      return missed * (1 - repeats);
    }
    double real = probability * echo[inBurst][answered(slot)];
    next.add(inBurst, HiddenState.ECHO, real);
    if (repeats > 0 && log.rangeM(ping) == log.rangeM(ping - 1)) {
      next.add(inBurst, slot + 1, missed * repeats);
      return real + missed * repeats;
    }
    return real;
  }
}
