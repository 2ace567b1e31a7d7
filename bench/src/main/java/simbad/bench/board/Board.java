package simbad.bench.board;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import simbad.sonar.format.DataFormatException;

/**
 * A simulated board that runs: gpsim with the ranger's program, and a thread that passes on what a
 * {@link BoardWorld} decides. Closing ends both and leaves no file behind. Safe for use by several
 * threads.
 */
public final class Board implements AutoCloseable {
  private static final int START_LIMIT_S = 30;
  private static final int END_LIMIT_S = 5;

  private final Process gpsim;
  private final ControlChannel control;
  private final Thread thread;
  private final Workplace workplace;
  private final Path link;

  private Board(Process gpsim, ControlChannel control, Workplace workplace, Path link) {
    this.gpsim = gpsim;
    this.control = control;
    this.workplace = workplace;
    this.link = link;
    thread = new Thread(control::serve, "simulated board");
    thread.setDaemon(true);
  }

  /**
   * Starts a board. Its serial port is open when this returns.
   *
   * @param kit what it is made of
   * @param setup how it runs
   * @param world what it meets
   * @throws IOException if a tool is missing, saying which and how to install it, or if gpsim does
   *     not start
   * @throws DataFormatException if the program cannot be read
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public static Board start(BoardKit kit, BoardSetup setup, BoardWorld world)
      throws IOException, DataFormatException, InterruptedException {
    refuseFile(setup.link());
    Workplace workplace = Workplace.create(kit, setup);
    try {
      return start(workplace, kit.environment(), setup, world);
    } catch (IOException | InterruptedException e) {
      workplace.delete();
      throw e;
    }
  }

  private static void refuseFile(Path link) throws IOException {
    if (Files.exists(link) && !Files.isSymbolicLink(link)) {
      throw new IOException(
          link + ": exists and is not a link, so the serial port's link cannot replace it");
    }
    Path folder = link.getParent();
    if (folder == null || !Files.isDirectory(folder)) {
      throw new IOException(link + ": there is no such directory for the serial port's link");
    }
  }

  private static Board start(
      Workplace workplace, Map<String, String> environment, BoardSetup setup, BoardWorld world)
      throws IOException, InterruptedException {
    try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
      server.bind(UnixDomainSocketAddress.of(workplace.socket()));
      Process gpsim = workplace.startGpsim(environment);
      try {
        SocketChannel channel = accept(server, gpsim, workplace);
        ControlChannel control = new ControlChannel(channel, world);
        Board board = new Board(gpsim, control, workplace, setup.link());
        board.thread.start();
        if (!control.awaitPort(START_LIMIT_S, TimeUnit.SECONDS)) {
          throw new IOException("gpsim opened no serial port: " + workplace.lastWords());
        }
        return board;
      } catch (IOException | InterruptedException e) {
        gpsim.destroyForcibly();
        throw e;
      }
    }
  }

  private static SocketChannel accept(
      ServerSocketChannel server, Process gpsim, Workplace workplace)
      throws IOException, InterruptedException {
    server.configureBlocking(false);
    for (int i = 0; i < START_LIMIT_S * 100; i++) {
      SocketChannel channel = server.accept();
      if (channel != null) {
        channel.configureBlocking(true);
        return channel;
      }
      if (gpsim.waitFor(10, TimeUnit.MILLISECONDS)) {
        break;
      }
    }
    throw new IOException("gpsim did not start: " + workplace.lastWords());
  }

  /** Returns the path under which the serial port can be opened, absolute. */
  public Path port() {
    return link;
  }

  /**
   * Tells the board something, at once or at the next simulated millisecond. Without effect when it
   * has ended.
   */
  public void order(BoardOrder... orders) {
    control.send(List.of(orders));
  }

  /** Tells whether it runs. */
  public boolean isRunning() {
    return gpsim.isAlive();
  }

  /**
   * Waits until the simulation has ended by itself, as after {@link BoardOrder#stop()}.
   *
   * @throws IOException if it ended otherwise, or if the world failed
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public void awaitEnd() throws IOException, InterruptedException {
    int status = gpsim.waitFor();
    thread.join();
    control.rethrowFailure();
    if (status != 0 || !control.stopped()) {
      throw new IOException(
          "gpsim ended with status " + status + control.complaint() + ": " + workplace.lastWords());
    }
  }

  @Override
  public void close() {
    control.send(List.of(BoardOrder.stop()));
    try {
      if (!gpsim.waitFor(END_LIMIT_S, TimeUnit.SECONDS)) {
        gpsim.destroyForcibly();
      }
    } catch (InterruptedException e) {
      gpsim.destroyForcibly();
      Thread.currentThread().interrupt();
    }
    control.close();
    deleteLink();
    workplace.delete();
  }

  /** The board deletes it itself, unless it was killed. */
  private void deleteLink() {
    try {
      if (Files.isSymbolicLink(link)) {
        Files.delete(link);
      }
    } catch (IOException e) {
      // A link that leads nowhere is no failure of the run.
    }
  }
}
