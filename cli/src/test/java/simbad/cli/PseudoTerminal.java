package simbad.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;

/** A pseudo-terminal: one end is a port that any program can open, the other one is here. */
final class PseudoTerminal implements AutoCloseable {
  private final Process bridge;
  private final Path path;

  private PseudoTerminal(Process bridge, Path path) {
    this.bridge = bridge;
    this.path = path;
  }

  /** Opens one; its program, bench's, is compiled the first time. */
  static PseudoTerminal open() throws IOException, InterruptedException {
    Path program = Path.of("target", "pty").toAbsolutePath();
    compile(program);
    Process bridge = new ProcessBuilder(program.toString()).start();
    StringBuilder name = new StringBuilder();
    for (int c = bridge.getInputStream().read(); c > '\n'; c = bridge.getInputStream().read()) {
      name.append((char) c);
    }
    return new PseudoTerminal(bridge, Path.of(name.toString()));
  }

  /** Once, however many tests ask for it at the same time, in this process or in another one. */
  private static synchronized void compile(Path program) throws IOException, InterruptedException {
    if (Files.exists(program)) {
      return;
    }
    Path compiled = Files.createTempFile(program.getParent(), "pty", null);
    Process cc =
        new ProcessBuilder("cc", "-o", compiled.toString(), "../bench/src/test/c/pty.c", "-lutil")
            .inheritIO()
            .start();
    if (cc.waitFor() != 0) {
      throw new IOException("pty.c cannot be compiled");
    }
    Files.setPosixFilePermissions(compiled, PosixFilePermissions.fromString("rwxr-xr-x"));
    Files.move(compiled, program, StandardCopyOption.ATOMIC_MOVE);
  }

  Path path() {
    return path;
  }

  /** What the program at the port sends. */
  InputStream in() {
    return bridge.getInputStream();
  }

  /** Sends to the program at the port; what nobody takes any more is lost. */
  void send(String text) {
    try {
      bridge.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      bridge.getOutputStream().flush();
    } catch (IOException e) {
      // The port has vanished.
    }
  }

  @Override
  public void close() {
    try {
      bridge.destroyForcibly().waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
