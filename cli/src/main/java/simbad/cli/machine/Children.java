package simbad.cli.machine;

import java.io.IOException;

/** Processes that do a part of the work in the sight of the user. */
final class Children {
  private Children() {}

  /**
   * Starts a process and waits for its end. It is ended, with those that it started, when this one
   * is told to end.
   *
   * @param builder what to start
   * @return its exit status
   */
  static int run(ProcessBuilder builder) throws IOException, InterruptedException {
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
  }
}
