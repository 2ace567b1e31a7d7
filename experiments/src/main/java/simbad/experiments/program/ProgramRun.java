package simbad.experiments.program;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import simbad.sim.Agent;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Eye;
import simbad.sim.SensorDevice;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.StepListener;
import simbad.sim.World;

/**
 * One run of a program without a window. Its main runs first; then whatever worlds it showed in the
 * main window, or started, are stepped. A main that sleeps meanwhile gets the steps of that time. A
 * program that steps by itself is ended after the number of steps.
 */
public final class ProgramRun implements StepListener {
  private static final long PATIENCE_S = 10;
  private static final int STEPS_PER_S = 20;
  private static final long LOOK_MS = 10;

  private static volatile @Nullable ProgramRun current;

  private final RunPlan plan;
  private final PoseTrace trace = new PoseTrace();
  private final Map<Simulator, Integer> numbers = new LinkedHashMap<>();
  private final Map<Simulator, Long> steps = new LinkedHashMap<>();
  private final List<Simulator> shown = new CopyOnWriteArrayList<>();
  private final Set<Simulator> begun = ConcurrentHashMap.newKeySet();
  private final Set<Simulator> stopped = ConcurrentHashMap.newKeySet();
  private final Set<Compatibility> touched = EnumSet.noneOf(Compatibility.class);
  private final @Nullable Pictures pictures;
  private final Queue<Runnable> events = new ConcurrentLinkedQueue<>();
  private volatile @Nullable Thread main;
  private volatile boolean mainMadeWorld;

  private ProgramRun(RunPlan plan, @Nullable Pictures pictures) {
    this.plan = plan;
    this.pictures = pictures;
  }

  /**
   * Runs a program to its end.
   *
   * @param pictures takes pictures of the first world; null for none
   * @throws ProgramException if the program fails, or opens no world
   */
  public static ProgramRun run(RunPlan plan, @Nullable Pictures pictures) throws ProgramException {
    ProgramRun run = new ProgramRun(plan, pictures);
    String before = System.getProperty(Compatibility.PROPERTY, "");
    System.setProperty(Compatibility.PROPERTY, plan.compatibility());
    StandIns.begin(plan.seed());
    current = run;
    Simulator.setListener(run);
    try {
      run.runMain();
      run.stepShown();
    } finally {
      Simulator.setListener(null);
      current = null;
      System.setProperty(Compatibility.PROPERTY, before);
    }
    if (run.numbers.isEmpty()) {
      throw new ProgramException(
          plan.mainClass() + " makes no world: no Simbad, no Simbatch", null);
    }
    run.numbers.keySet().forEach(simulator -> run.touched.addAll(simulator.getWorld().touched()));
    return run;
  }

  /**
   * A window was asked for, or the program started a simulation: it is stepped when the program's
   * main has ended or sleeps.
   */
  static void started(Simulator simulator) {
    ProgramRun run = current;
    if (run != null) {
      run.stopped.remove(simulator);
      if (run.begun.contains(simulator)) {
        simulator.initBehaviors();
      } else if (!run.shown.contains(simulator)) {
        run.shown.add(simulator);
      }
    }
  }

  /** The program wants something done by the thread of its windows, which is that of its steps. */
  static void later(Runnable event) {
    ProgramRun run = current;
    if (run != null) {
      run.events.add(event);
    }
  }

  /** Does what the program wanted done later, in the order in which it did. */
  static void doEvents() {
    ProgramRun run = current;
    if (run != null) {
      run.drain();
    }
  }

  /** An event may bring forth others, as a window does that asks for its repainting. */
  private void drain() {
    Runnable event = events.poll();
    while (event != null) {
      event.run();
      event = events.poll();
    }
  }

  /** The program stopped a simulation: it gets no more steps unless it is started again. */
  static void stopped(Simulator simulator) {
    ProgramRun run = current;
    if (run != null) {
      run.stopped.add(simulator);
    }
  }

  /**
   * Does the steps of a time for which a program's main sleeps.
   *
   * @return false if the thread is not that of a main whose simulation has begun
   */
  static boolean stepFor(long millis) {
    ProgramRun run = current;
    if (run == null || Thread.currentThread() != run.main) {
      return false;
    }
    run.drain();
    if (run.shown.isEmpty()) {
      return false;
    }
    if (run.shown.stream().allMatch(simulator -> run.done(simulator) >= run.plan.steps())) {
      throw new ProgramEnd();
    }
    long due = (millis * STEPS_PER_S + 999) / 1000;
    StandIns.setStepping(true);
    try {
      for (Simulator simulator : run.shown) {
        run.step(simulator, Math.min(run.plan.steps(), run.done(simulator) + due));
      }
    } finally {
      StandIns.setStepping(false);
    }
    return true;
  }

  private void runMain() throws ProgramException {
    ProgramLoader loader = new ProgramLoader(plan.classes(), true);
    Throwable[] fault = new Throwable[1];
    ThreadGroup group = new ThreadGroup("program");
    Thread thread = new Thread(group, () -> fault[0] = faultOfMain(loader), "program");
    main = thread;
    thread.setDaemon(true);
    thread.setContextClassLoader(loader);
    thread.start();
    try {
      while (thread.isAlive()) {
        thread.join(TimeUnit.SECONDS.toMillis(PATIENCE_S));
        if (!shown.isEmpty()) {
          break;
        }
      }
      awaitWorld(group);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ProgramException("interrupted", e);
    }
    if (fault[0] != null) {
      throw ProgramException.of(plan.mainClass(), fault[0]);
    }
  }

  /**
   * A main may leave it to a thread of its own to make the world, and to show it or to step it. A
   * world that is made is not yet shown.
   */
  private void awaitWorld(ThreadGroup group) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!mainMadeWorld
        && shown.isEmpty()
        && group.activeCount() > 0
        && System.nanoTime() < end) {
      Thread.sleep(LOOK_MS);
    }
  }

  private @Nullable Throwable faultOfMain(ProgramLoader loader) {
    try {
      Class<?> type = loader.loadClass(plan.mainClass());
      if (plan.hasMain()) {
        var main = type.getMethod("main", String[].class);
        main.setAccessible(true);
        main.invoke(null, (Object) plan.arguments().toArray(String[]::new));
        drain();
      } else {
        var constructor = type.getDeclaredConstructor();
        constructor.setAccessible(true);
        new HeadlessFrame((EnvironmentDescription) constructor.newInstance(), false);
      }
      return null;
    } catch (InvocationTargetException e) {
      return e.getCause() instanceof ProgramEnd ? null : e.getCause();
    } catch (ProgramEnd e) {
      return null;
    } catch (ReflectiveOperationException | Error | RuntimeException e) {
      return e;
    }
  }

  private void stepShown() throws ProgramException {
    StandIns.setStepping(true);
    // A step may open another world.
    for (int i = 0; i < shown.size(); i++) {
      Simulator simulator = shown.get(i);
      try {
        step(simulator, plan.steps());
      } catch (ProgramEnd e) {
        // That was the last step.
      } catch (RuntimeException | Error e) {
        throw ProgramException.of("step " + (done(simulator) + 1), e);
      }
    }
    StandIns.setStepping(false);
  }

  /** Steps until so many steps are done, or the program stops it. */
  private void step(Simulator simulator, long until) {
    if (begun.add(simulator)) {
      simulator.initBehaviors();
    }
    while (done(simulator) < until && !stopped.contains(simulator)) {
      simulator.simulateOneStep();
      drain();
    }
  }

  private long done(Simulator simulator) {
    return steps.getOrDefault(simulator, 0L);
  }

  @Override
  public void made(Simulator simulator, World world) {
    if (Thread.currentThread() == main) {
      mainMadeWorld = true;
    }
    numbers.put(simulator, numbers.size() + 1);
    record(simulator, 0);
  }

  /** Ends a program that steps by itself when it asks for one step too many. */
  @Override
  public void stepping(Simulator simulator) {
    if (done(simulator) >= plan.steps()) {
      throw new ProgramEnd();
    }
  }

  @Override
  public void stepped(Simulator simulator) {
    long step = done(simulator) + 1;
    steps.put(simulator, step);
    StandIns.pass(TimeUnit.SECONDS.toNanos(1) / STEPS_PER_S);
    record(simulator, step);
    note(simulator);
  }

  private void record(Simulator simulator, long step) {
    int world = numbers.getOrDefault(simulator, 0);
    if (plan.traced()) {
      simulator.getAgentList().forEach(agent -> trace.add(world, step, agent));
    }
    if (pictures != null && world == 1) {
      try {
        pictures.offer(simulator.getWorld(), step);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** Notes what robots see of each other, which no single decision depends on. */
  private void note(Simulator simulator) {
    List<SimpleAgent> agents = simulator.getAgentList();
    long robots = agents.stream().filter(Agent.class::isInstance).count();
    if (robots < 2) {
      return;
    }
    for (SimpleAgent agent : agents) {
      for (SensorDevice sensor : agent.getSensorList()) {
        if (sensor instanceof Eye) {
          touched.add(Compatibility.NOSES_FLOAT);
        } else {
          touched.add(Compatibility.ROBOTS_ARE_PRISMS);
        }
      }
    }
  }

  /** Returns where the agents were, if that was wanted. */
  public PoseTrace trace() {
    return trace;
  }

  /** Returns the switches on which something in the run depended. */
  public Set<Compatibility> touched() {
    return touched;
  }

  /** Returns how many worlds the program made. */
  public int worlds() {
    return numbers.size();
  }

  /** Returns how many steps were done, of all worlds. */
  public long steps() {
    return steps.values().stream().mapToLong(Long::longValue).sum();
  }

  /** Returns how many agents there are at the end, in all worlds. */
  public int agents() {
    return numbers.keySet().stream().mapToInt(s -> s.getAgentList().size()).sum();
  }
}
