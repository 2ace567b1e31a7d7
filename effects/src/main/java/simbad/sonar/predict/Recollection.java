package simbad.sonar.predict;

import java.util.random.RandomGenerator;
import simbad.sonar.change.Burst;
import simbad.sonar.change.StaleReading;
import simbad.sonar.ping.Mixture;

/** What one transducer remembers of the pings before, and what it reads of the next. */
final class Recollection {
  private final ChangedModel model;
  private final Memory memory;
  private final PingModel pings;
  private final Mixture mixture = new Mixture();

  /** What the reading before came from; no part where there was none. */
  private final Mixture before = new Mixture();

  private boolean started;
  private boolean inBurst;

  /** As in {@link HiddenState}. */
  private int slot;

  private double lastM;
  private double lastEchoS;

  /**
   * Starts with nothing to remember.
   *
   * @param model what is read
   * @param pings the model's pings, shared with other transducers
   */
  Recollection(ChangedModel model, PingModel pings) {
    this.model = model;
    this.pings = pings;
    memory = model.memory();
  }

  /**
   * Reads a ping.
   *
   * @param ping its index in the geometry of the pings
   * @param timeS of the ping; never decreases
   * @param random source of chance
   * @return what is read in metres; infinity for no echo
   */
  double read(int ping, double timeS, RandomGenerator random) {
    passBurst(random);
    boolean heard = slot == HiddenState.ECHO;
    pings.mix(ping, heard, before, memory.lost(inBurst ? 1 : 0), mixture);
    int part = mixture.draw(random);
    return part < mixture.size() ? echo(part, timeS, random) : miss(timeS, random);
  }

  private void passBurst(RandomGenerator random) {
    if (memory.burst() != null) {
      Burst burst = memory.burst();
      double silenced = inBurst ? 1 - burst.ends() : burst.begins();
      inBurst = random.nextDouble() < (started ? silenced : burst.share());
    }
    started = true;
  }

  private double echo(int part, double timeS, RandomGenerator random) {
    double measured = mixture.drawM(part, random);
    boolean known = mixture.halfWidthM(part) == 0;
    before.clear();
    slot = HiddenState.ECHO;
    lastM = model.reportedM(measured);
    before.add(memory.asRead() ? lastM : known ? mixture.meanM(part) : measured, 0, 1);
    lastEchoS = timeS;
    return lastM;
  }

  private double miss(double timeS, RandomGenerator random) {
    double repeats = memory.repeats(slot, timeS - lastEchoS);
    if (slot <= StaleReading.MOST_REPEATS && repeats > 0 && random.nextDouble() < repeats) {
      slot++;
      return lastM;
    }
    slot = 0;
    before.clear();
    return Double.POSITIVE_INFINITY;
  }
}
