package simbad.experiments.program;

import java.awt.Dimension;
import java.awt.Toolkit;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import simbad.sim.Simulator;

/** What a program's calls are sent to that would make its run differ from the next one. */
public final class StandIns {
  /** 1 January 2000, of which a seed is as many milliseconds off. */
  private static final long FIRST_MILLIS = 946_684_800_000L;

  /** Whoever waits for the clock without sleeping comes to an end, too. */
  private static final long NANOS_PER_LOOK = 1000;

  private static final Dimension SCREEN = new Dimension(1280, 800);

  /** Set anew before each run; the program has it to itself. */
  private static volatile Random chance = new Random(0);

  private static volatile long seeds;
  private static final AtomicLong CLOCK_NANOS = new AtomicLong();
  private static final ThreadLocal<Boolean> STEPPING = ThreadLocal.withInitial(() -> false);

  private StandIns() {}

  /** Begins a run: all chance, and the clock, follow from a seed. */
  static void begin(long seed) {
    chance = new Random(seed);
    seeds = seed;
    CLOCK_NANOS.set(TimeUnit.MILLISECONDS.toNanos(seed));
  }

  /** Says whether this thread does steps, which wait for no clock. */
  static void setStepping(boolean stepping) {
    STEPPING.set(stepping);
  }

  /** Lets the clock of the run go on. */
  static void pass(long nanos) {
    CLOCK_NANOS.addAndGet(nanos);
  }

  /** Stands in for {@code Math.random}. */
  public static double random() {
    return chance.nextDouble();
  }

  /** Stands in for {@code Collections.shuffle} without a generator. */
  public static void shuffle(List<?> list) {
    Collections.shuffle(list, chance);
  }

  /** Stands in for {@code System.exit}: the program ends, this process does not. */
  @SuppressWarnings("DoNotCallSuggester") // Only rewritten programs call it.
  public static void exit(int status) {
    throw new ProgramEnd();
  }

  /** Stands in for {@code System.nanoTime}: time goes with the steps. */
  public static long nanoTime() {
    return CLOCK_NANOS.addAndGet(NANOS_PER_LOOK);
  }

  /** Stands in for {@code System.currentTimeMillis}, likewise. */
  public static long currentTimeMillis() {
    return FIRST_MILLIS + TimeUnit.NANOSECONDS.toMillis(nanoTime());
  }

  /**
   * Stands in for {@code Thread.sleep}. Within a step it takes no time; before, in the program's
   * main, it takes the steps of that time.
   */
  public static void sleep(long millis) throws InterruptedException {
    if (STEPPING.get()) {
      pass(TimeUnit.MILLISECONDS.toNanos(millis));
    } else if (!ProgramRun.stepFor(millis)) {
      Thread.sleep(millis);
    }
  }

  /**
   * Stands in for {@code SwingUtilities.invokeLater} and that of the event queue: it is done when
   * the program's main ends or sleeps, or after the step.
   */
  public static void invokeLater(Runnable event) {
    ProgramRun.later(event);
  }

  /** Stands in for {@code invokeAndWait}: what was to come later comes before. */
  public static void invokeAndWait(Runnable event) {
    ProgramRun.later(event);
    ProgramRun.doEvents();
  }

  /** Stands in for {@code Simulator.startSimulation}: steps come when the main ends or sleeps. */
  public static void start(Simulator simulator) {
    ProgramRun.started(simulator);
  }

  /** Stands in for {@code Simulator.restartSimulation}. */
  public static void restart(Simulator simulator) {
    simulator.resetSimulation();
    ProgramRun.started(simulator);
  }

  /** Stands in for {@code Simulator.stopSimulation}. */
  public static void stop(Simulator simulator) {
    ProgramRun.stopped(simulator);
  }

  /** Returns the size of a screen that is not there. */
  public static Dimension getScreenSize(@Nullable Toolkit toolkit) {
    return new Dimension(SCREEN);
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

    /** Stands in for {@code ThreadLocalRandom.current}. */
    public static Chance current() {
      return new Chance();
    }

    private static synchronized long nextSeed() {
      seeds++;
      return seeds * 0x9E3779B97F4A7C15L;
    }
  }
}
