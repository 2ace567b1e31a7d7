package simbad.sonar.predict;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.change.Burst;
import simbad.sonar.change.StaleReading;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.PingLog;

/**
 * What is expected of each ping when no reading is known: memory runs forward by probabilities.
 *
 * <p>For each state of the burst and each slot of {@link HiddenState} it keeps what the ping before
 * may have read in that state, with the probability of the state as the sum of the shares.
 */
final class Forecast {
  /** Ghosts of ghosts of ghosts would fill any memory: what hardly ever happens is not followed. */
  private static final double FOLLOWED = 1e-7;

  /** The ghost of an echo of a lesser share is left out. */
  private static final double HAUNTS = 1e-5;

  /** Of so many echoes at most, the likeliest, ghosts are followed: else they multiply. */
  private static final int HAUNTING = 24;

  /** The least share that is worth a part in a distribution, which is asked for quantiles. */
  private static final double TOLD = 1e-5;

  private final ChangedModel model;
  private final PingLog log;
  private final PingModel pings;
  private final Memory memory;

  /** Whether what comes depends on what was read, and not only on whether something was. */
  private final boolean onEachReading;

  private final Mixture mixture = new Mixture();
  private final Mixture one = new Mixture();
  private Mixture[][] state = states();
  private Mixture[][] next = states();
  private final double[] nothing = new double[2];
  private final double[] nextNothing = new double[2];
  private int slots;

  Forecast(ChangedModel model, Geometry geometry) {
    this.model = model;
    log = geometry.log();
    pings = model.pings(geometry);
    memory = model.memory();
    boolean several = geometry.obstacles() > 1;
    onEachReading = memory.ghosts() || (several && memory.hysteresis() != null);
  }

  private static Mixture[][] states() {
    Mixture[][] states = new Mixture[2][StaleReading.MOST_REPEATS + 2];
    for (Mixture[] some : states) {
      for (int slot = 0; slot < some.length; slot++) {
        some[slot] = new Mixture();
      }
    }
    return states;
  }

  List<ReadingDistribution> all() {
    List<ReadingDistribution> all = new ArrayList<>(log.size());
    for (int ping = 0; ping < log.size(); ping++) {
      if (memory.isNone()) {
        pings.mix(ping, false, Mixture.EMPTY, 0, mixture);
        all.add(model.distribution(mixture));
      } else {
        all.add(model.distribution(step(ping)));
      }
    }
    return all;
  }

  private Mixture step(int ping) {
    if (log.sequenceStart(ping) == ping) {
      start();
    } else if (memory.burst() != null) {
      pass(memory.burst());
    }
    clear(next);
    for (int inBurst = 0; inBurst < 2; inBurst++) {
      nextNothing[inBurst] = 0;
      advanceNothing(ping, inBurst);
      for (int slot = 1; slot < slots; slot++) {
        advance(ping, inBurst, slot);
      }
    }
    slots = memory.stale() == null ? 2 : Math.min(slots + 1, StaleReading.MOST_REPEATS + 2);
    if (onEachReading) {
      blur();
    }
    Mixture[][] spent = state;
    state = next;
    next = spent;
    System.arraycopy(nextNothing, 0, nothing, 0, 2);
    return read();
  }

  private void blur() {
    for (int slot = 1; slot < slots; slot++) {
      next[0][slot].blur();
      next[1][slot].blur();
    }
  }

  private void start() {
    clear(state);
    clear(next);
    nothing[0] = 1 - memory.burstShare();
    nothing[1] = memory.burstShare();
    slots = 1;
  }

  private static void clear(Mixture[][] states) {
    for (Mixture[] some : states) {
      for (Mixture each : some) {
        each.clear();
      }
    }
  }

  private void pass(Burst burst) {
    double clear = nothing[0];
    nothing[0] = clear * (1 - burst.begins()) + nothing[1] * burst.ends();
    nothing[1] = nothing[1] * (1 - burst.ends()) + clear * burst.begins();
    clear(next);
    for (int slot = 1; slot < slots; slot++) {
      next[0][slot].merge(state[0][slot], 1 - burst.begins(), FOLLOWED);
      next[0][slot].merge(state[1][slot], burst.ends(), FOLLOWED);
      next[1][slot].merge(state[1][slot], 1 - burst.ends(), FOLLOWED);
      next[1][slot].merge(state[0][slot], burst.begins(), FOLLOWED);
    }
    Mixture[][] spent = state;
    state = next;
    next = spent;
  }

  private void advanceNothing(int ping, int inBurst) {
    if (nothing[inBurst] > 0) {
      nextNothing[inBurst] += nothing[inBurst] * expect(ping, inBurst, 0, nothing[inBurst]);
    }
  }

  private void advance(int ping, int inBurst, int slot) {
    Mixture before = state[inBurst][slot];
    if (before.size() == 0) {
      return;
    }
    double repeats = memory.repeats(slot, log.timeS(ping) - log.timeS(ping - slot));
    if (onEachReading) {
      double least = Math.max(HAUNTS, before.shareOfRank(HAUNTING));
      double rest = 0;
      for (int part = 0; part < before.size(); part++) {
        rest += before.share(part) > least ? 0 : before.share(part);
      }
      one.clear();
      double silentAfterRest = rest > 0 ? expect(ping, inBurst, slot, rest) : 0;
      for (int part = 0; part < before.size(); part++) {
        if (!(before.share(part) > least)) {
          miss(inBurst, slot, part, before.share(part) * silentAfterRest, repeats);
          continue;
        }
        one.clear();
        one.add(before.meanM(part), spreadM(before, part), 1);
        double silent = expect(ping, inBurst, slot, before.share(part));
        miss(inBurst, slot, part, before.share(part) * silent, repeats);
      }
    } else {
      double silent = expect(ping, inBurst, slot, before.echoShare());
      for (int part = 0; part < before.size(); part++) {
        miss(inBurst, slot, part, before.share(part) * silent, repeats);
      }
    }
  }

  /** What a ghost scatters by because the reading before does; what answered stays where it is. */
  private double spreadM(Mixture before, int part) {
    double own = memory.asRead() ? before.deviationM(part) : 0;
    return Math.hypot(own, before.evenSpreadM(part));
  }

  /** Adds what a ping reads after a state, times the state's share; returns the chance of none. */
  private double expect(int ping, int inBurst, int slot, double share) {
    Mixture before = slot > 0 && onEachReading ? one : Mixture.EMPTY;
    pings.mix(ping, slot == HiddenState.ECHO, before, memory.lost(inBurst), mixture);
    next[inBurst][HiddenState.ECHO].merge(mixture, share, FOLLOWED);
    return Math.max(0, 1 - mixture.echoShare());
  }

  private void miss(int inBurst, int slot, int part, double missed, double repeats) {
    if (repeats > 0 && slot < StaleReading.MOST_REPEATS + 1) {
      next[inBurst][slot + 1].addPart(state[inBurst][slot], part, missed * repeats);
      nextNothing[inBurst] += missed * (1 - repeats);
    } else {
      nextNothing[inBurst] += missed;
    }
  }

  private Mixture read() {
    mixture.clear();
    for (int slot = 1; slot < slots; slot++) {
      mixture.merge(state[0][slot], 1, TOLD);
      mixture.merge(state[1][slot], 1, TOLD);
    }
    mixture.blur();
    return mixture;
  }
}
