package simbad.cli.machine;

import java.io.IOException;

/** Processes that do a part of the work in the sight of the user. */
public final class Children {
  private Children() {}

  /**
   * Starts a process and waits for its end. When this one is told to end, it ends that one first,
   * with those that it started.
   *
   * @param builder what to start
   * @return its exit status
   * @throws IOException if it cannot be started
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public static int run(ProcessBuilder builder) throws IOException, InterruptedException {
    Process process = builder.start();
    Thread atEnd = new Thread(() -> end(process.toHandle()));
    Runtime.getRuntime().addShutdownHook(atEnd);
    int status = process.waitFor();
    try {
      Runtime.getRuntime().removeShutdownHook(atEnd);
    } catch (IllegalStateException ends) {
      // The end has come meanwhile.
      return status;
    }
    return status;
  }

  private static void end(ProcessHandle process) {
    process.descendants().forEach(ProcessHandle::destroy);
    process.destroy();
    process.onExit().join();
  }
}
