package simbad.experiments.program;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import simbad.gui.Simbad;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;

/** Runs a program with the window that it opens. */
public final class WindowRun {
  /** So long a thread of the program may take until its window is there. */
  private static final long PATIENCE_S = 10;

  private static final long LOOK_MS = 50;

  private WindowRun() {}

  /**
   * Starts a program and returns when its main has ended and its window was closed.
   *
   * @throws ProgramException if its main fails
   */
  public static void run(RunPlan plan) throws ProgramException {
    System.setProperty(Compatibility.PROPERTY, plan.compatibility());
    StandIns.begin(plan.seed());
    ProgramLoader loader = new ProgramLoader(plan.classes(), false);
    Thread.currentThread().setContextClassLoader(loader);
    try {
      Class<?> type = loader.loadClass(plan.mainClass());
      if (plan.hasMain()) {
        Object arguments = plan.arguments().toArray(String[]::new);
        type.getMethod("main", String[].class).invoke(null, arguments);
      } else {
        new Simbad((EnvironmentDescription) type.getDeclaredConstructor().newInstance(), false);
      }
      Simbad window = awaitWindow(loader);
      if (window != null) {
        window.awaitClosed();
      }
    } catch (InvocationTargetException e) {
      if (!(e.getCause() instanceof ProgramEnd)) {
        throw ProgramException.of(plan.mainClass(), e.getTargetException());
      }
    } catch (ReflectiveOperationException | LinkageError | InterruptedException e) {
      throw ProgramException.of(plan.mainClass(), e);
    }
  }

  /** A main may leave its window to the event thread, as Swing wants it, or to one of its own. */
  private static @Nullable Simbad awaitWindow(ClassLoader loader)
      throws InterruptedException, InvocationTargetException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    Simbad window = Simbad.getSimbadInstance();
    while (window == null) {
      // What is in the queue now is done when this is.
      EventQueue.invokeAndWait(() -> {});
      boolean mayCome = System.nanoTime() < end && isAtWork(loader);
      window = Simbad.getSimbadInstance();
      if (!mayCome) {
        break;
      }
      Thread.sleep(LOOK_MS);
    }
    return window;
  }

  /** Whether a thread that the program started is there; they have its loader from its main. */
  private static boolean isAtWork(ClassLoader loader) {
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(
            thread ->
                thread.getContextClassLoader() == loader
                    && thread != Thread.currentThread()
                    && !thread.isDaemon());
  }
}
