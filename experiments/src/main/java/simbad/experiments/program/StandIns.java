package simbad.experiments.program;

import java.util.Random;

/** What a program's calls are sent to that would make its run differ from the next one. */
public final class StandIns {
  /** Set anew before each run; the program has it to itself. */
  private static volatile Random chance = new Random(0);

  private static volatile long seeds;
  private static final ThreadLocal<Boolean> STEPPING = ThreadLocal.withInitial(() -> false);

  private StandIns() {}

  /** Begins a run: all chance follows from a seed. */
  static void begin(long seed) {
    chance = new Random(seed);
    seeds = seed;
  }

  /** Says whether this thread does steps, which wait for no clock. */
  static void setStepping(boolean stepping) {
    STEPPING.set(stepping);
  }

  /** Stands in for {@code Math.random}. */
  public static double random() {
    return chance.nextDouble();
  }

  /** Stands in for {@code System.exit}: the program ends, this process does not. */
  @SuppressWarnings("DoNotCallSuggester") // Only rewritten programs call it.
  public static void exit(int status) {
    throw new ProgramEnd();
  }

  /** Stands in for {@code Thread.sleep}: no step waits for a clock. */
  public static void sleep(long millis) throws InterruptedException {
    if (!STEPPING.get()) {
      Thread.sleep(millis);
    }
  }

  /** Stands in for {@code java.util.Random}: without a seed it has one of the run. */
  public static class Chance extends Random {
    private static final long serialVersionUID = 1;

    /** Takes the run's next seed. */
    public Chance() {
      super(nextSeed());
    }

    /** Is as random as any with this seed. */
    public Chance(long seed) {
      super(seed);
    }

    private static synchronized long nextSeed() {
      seeds++;
      return seeds * 0x9E3779B97F4A7C15L;
    }
  }
}
