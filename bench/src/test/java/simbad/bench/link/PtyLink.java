package simbad.bench.link;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;

/** The far end of a real pseudo-terminal, whose near end any program can open by its path. */
public final class PtyLink implements SerialLink {
  private final Process bridge;
  private final InputStream in;
  private final Path path;

  private PtyLink(Process bridge) throws IOException {
    this.bridge = bridge;
    in = bridge.getInputStream();
    StringBuilder name = new StringBuilder();
    for (int c = in.read(); c != '\n' && c >= 0; c = in.read()) {
      name.append((char) c);
    }
    path = Path.of(name.toString());
  }

  /** Opens one; its program is compiled the first time. */
  public static PtyLink open() throws IOException, InterruptedException {
    Path program = Path.of("target", "pty").toAbsolutePath();
    synchronized (PtyLink.class) {
      if (!Files.exists(program)) {
        Process cc =
            new ProcessBuilder("cc", "-o", program.toString(), "src/test/c/pty.c", "-lutil")
                .redirectErrorStream(true)
                .start();
        String said = new String(cc.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, cc.waitFor(), said);
      }
    }
    return new PtyLink(new ProcessBuilder(program.toString()).start());
  }

  /** Where the near end is. */
  public Path path() {
    return path;
  }

  @Override
  public int read(byte[] buffer, Duration limit) throws IOException {
    long endNs = System.nanoTime() + limit.toNanos();
    while (in.available() == 0) {
      if (!bridge.isAlive()) {
        throw new IOException("the pseudo-terminal is gone");
      }
      if (System.nanoTime() >= endNs) {
        return 0;
      }
      pause();
    }
    return in.read(buffer);
  }

  private static void pause() throws IOException {
    try {
      Thread.sleep(1);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    bridge.getOutputStream().write(bytes);
    bridge.getOutputStream().flush();
  }

  @Override
  public void close() {
    bridge.destroyForcibly();
    try {
      bridge.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
