package simbad.scene3d;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.util.Arrays;
import java.util.Optional;
import javax.media.j3d.GraphicsConfigTemplate3D;

/**
 * Asks the screen for a configuration that Java 3D can draw with, without the second that Java 3D
 * waits at the end of it: for a notification that came before, or never comes. Whoever interrupts
 * that wait gets the same answer at once.
 */
final class ConfigurationQuery {
  private static final long LOOK_MS = 10;
  private static final String RENDERER = "J3D-Renderer";
  private static final String WAITING = "getBestConfiguration";

  private ConfigurationQuery() {}

  /** Returns the default screen's best configuration for a template; empty if none will do. */
  static Optional<GraphicsConfiguration> ask(GraphicsConfigTemplate3D template) {
    GraphicsDevice screen =
        GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
    Thread waker = new Thread(ConfigurationQuery::wakeRenderer, "Java 3D query");
    waker.setDaemon(true);
    waker.start();
    try {
      return Optional.ofNullable(screen.getBestConfiguration(template));
    } finally {
      waker.interrupt();
    }
  }

  private static void wakeRenderer() {
    try {
      Optional<Thread> waiting = Optional.empty();
      while (waiting.isEmpty()) {
        Thread.sleep(LOOK_MS);
        waiting =
            Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith(RENDERER))
                .filter(ConfigurationQuery::waits)
                .findAny();
      }
      waiting.get().interrupt();
    } catch (InterruptedException e) {
      // The answer is there.
      Thread.currentThread().interrupt();
    }
  }

  /** Returns true if a thread is in the very wait, not in one of Java 3D's other ones. */
  private static boolean waits(Thread thread) {
    return thread.getState() == Thread.State.TIMED_WAITING
        && Arrays.stream(thread.getStackTrace())
            .filter(frame -> !frame.getClassName().equals(Object.class.getName()))
            .findFirst()
            .filter(frame -> frame.getMethodName().equals(WAITING))
            .isPresent();
  }
}
