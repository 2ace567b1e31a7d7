package simbad.experiments.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** A process that ends when it is closed, and when this program ends. */
final class ChildProcess implements AutoCloseable {
  private final Process process;
  private final Thread killer;
  private final Thread reader;

  private ChildProcess(Process process, Consumer<String> complaints) {
    this.process = process;
    this.killer = new Thread(process::destroy);
    this.reader = new Thread(() -> read(process, complaints));
  }

  /**
   * Starts a process.
   *
   * @param command with its arguments
   * @param folder that it runs in
   * @param out where its results go; nothing: nowhere
   * @param complaints told, from another thread, each line of its standard error
   */
  static ChildProcess start(
      List<String> command, Path folder, Optional<Path> out, Consumer<String> complaints)
      throws IOException {
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toAbsolutePath().toFile())
            .redirectOutput(out.map(file -> Redirect.to(file.toFile())).orElse(Redirect.DISCARD))
            .start();
    ChildProcess child = new ChildProcess(process, complaints);
    Runtime.getRuntime().addShutdownHook(child.killer);
    child.reader.start();
    process.getOutputStream().close();
    return child;
  }

  private static void read(Process process, Consumer<String> complaints) {
    try (BufferedReader lines = process.errorReader()) {
      lines.lines().forEach(complaints);
    } catch (IOException | UncheckedIOException e) {
      // It was ended while it spoke: there is nothing more to hear.
    }
  }

  /** The exit status, all complaints heard; nothing when it still runs after the time. */
  Optional<Integer> await(Duration time) throws InterruptedException {
    if (!process.waitFor(time.toMillis(), TimeUnit.MILLISECONDS)) {
      return Optional.empty();
    }
    reader.join();
    return Optional.of(process.exitValue());
  }

  /** Ends the process if it still runs, and waits until it has. */
  @Override
  public void close() {
    process.destroyForcibly();
    process.onExit().join();
    try {
      Runtime.getRuntime().removeShutdownHook(killer);
    } catch (IllegalStateException exiting) {
      // The hook runs already.
    }
  }
}
