package simbad.gui;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Carries out, one after the other, what the user tells the simulator. A step that takes long may
 * hold such a command up, but not the event thread.
 */
final class Commands {
  private static final ExecutorService QUEUE =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread thread = new Thread(task, "simulator commands");
            thread.setDaemon(true);
            return thread;
          });

  private Commands() {}

  static void run(Runnable command) {
    QUEUE.execute(command);
  }
}
