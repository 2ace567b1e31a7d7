package simbad.experiments.program;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
 * main window are stepped. A program that steps by itself is ended after the number of steps.
 */
public final class ProgramRun implements StepListener {
  private static final long PATIENCE_S = 10;

  private static volatile @Nullable ProgramRun current;

  private final RunPlan plan;
  private final PoseTrace trace = new PoseTrace();
  private final Map<Simulator, Integer> numbers = new LinkedHashMap<>();
  private final Map<Simulator, Long> steps = new LinkedHashMap<>();
  private final List<Simulator> shown = new ArrayList<>();
  private final Set<Compatibility> touched = EnumSet.noneOf(Compatibility.class);
  private final @Nullable Pictures pictures;

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

  /** A window was asked for: its world is stepped when the program's main has ended. */
  static void opened(Simulator simulator) {
    ProgramRun run = current;
    if (run != null) {
      run.shown.add(simulator);
    }
  }

  private void runMain() throws ProgramException {
    ProgramLoader loader = new ProgramLoader(plan.classes(), true);
    Throwable[] fault = new Throwable[1];
    Thread main =
        new Thread(
            () -> {
              StandIns.setStepping(false);
              fault[0] = faultOfMain(loader);
            },
            "program");
    main.setDaemon(true);
    main.setContextClassLoader(loader);
    main.start();
    try {
      while (main.isAlive()) {
        main.join(TimeUnit.SECONDS.toMillis(PATIENCE_S));
        if (!shown.isEmpty()) {
          break;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ProgramException("interrupted", e);
    }
    if (fault[0] != null) {
      throw ProgramException.of(plan.mainClass(), fault[0]);
    }
  }

  private @Nullable Throwable faultOfMain(ProgramLoader loader) {
    try {
      Class<?> type = loader.loadClass(plan.mainClass());
      if (plan.hasMain()) {
        var main = type.getMethod("main", String[].class);
        main.setAccessible(true);
        main.invoke(null, (Object) plan.arguments().toArray(String[]::new));
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
    } catch (ReflectiveOperationException | LinkageError | RuntimeException e) {
      return e;
    }
  }

  private void stepShown() throws ProgramException {
    StandIns.setStepping(true);
    for (Simulator simulator : shown) {
      try {
        simulator.initBehaviors();
        while (done(simulator) < plan.steps()) {
          simulator.simulateOneStep();
        }
      } catch (ProgramEnd e) {
        // That was the last step.
      } catch (RuntimeException | LinkageError e) {
        throw ProgramException.of("step " + (done(simulator) + 1), e);
      }
    }
    StandIns.setStepping(false);
  }

  private long done(Simulator simulator) {
    return steps.getOrDefault(simulator, 0L);
  }

  @Override
  public void made(Simulator simulator, World world) {
    numbers.put(simulator, numbers.size() + 1);
    record(simulator, 0);
  }

  @Override
  public void stepped(Simulator simulator) {
    long step = done(simulator) + 1;
    steps.put(simulator, step);
    record(simulator, step);
    note(simulator);
    if (step >= plan.steps()) {
      throw new ProgramEnd();
    }
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
