package simbad.experiments.program;

import java.lang.reflect.InvocationTargetException;
import simbad.gui.Simbad;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;

/** Runs a program with the window that it opens. */
public final class WindowRun {
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
      Simbad window = Simbad.getSimbadInstance();
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
}
