package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** A process that ends when it is closed, and when this program ends. */
final class ChildProcess implements AutoCloseable {
  private final Process process;
  private final Ending atEnd;
  private final Thread reader;

  private ChildProcess(Process process, Thread reader) {
    this.process = process;
    this.atEnd = Ending.with(process::destroy);
    this.reader = reader;
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
    process.getOutputStream().close();
    return begun(process, process.errorReader(), complaints);
  }

  /**
   * Starts a process that is told what to do line by line.
   *
   * @param command with its arguments
   * @param folder that it runs in
   * @param heard told, from another thread, each line of both its outputs
   */
  static ChildProcess spokenTo(List<String> command, Path folder, Consumer<String> heard)
      throws IOException {
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toAbsolutePath().toFile())
            .redirectErrorStream(true)
            .start();
    return begun(process, process.inputReader(StandardCharsets.UTF_8), heard);
  }

  private static ChildProcess begun(Process process, BufferedReader lines, Consumer<String> heard) {
    ChildProcess child = new ChildProcess(process, new Thread(() -> read(lines, heard)));
    child.reader.start();
    return child;
  }

  private static void read(BufferedReader source, Consumer<String> heard) {
    try (BufferedReader lines = source) {
      lines.lines().forEach(heard);
    } catch (IOException | UncheckedIOException e) {
      // It was ended while it spoke: there is nothing more to hear.
    }
  }

  /** Tells it a line; a process that has ended does not hear it. */
  void say(String line) {
    PrintWriter input = new PrintWriter(process.outputWriter(StandardCharsets.UTF_8));
    input.print(line + "\n");
    input.flush();
  }

  /** Tells whether it has ended and all that it said was heard. */
  boolean hasEnded() {
    return !process.isAlive() && !reader.isAlive();
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
    atEnd.close();
  }
}
