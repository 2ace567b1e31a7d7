package simbad.studio;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Clients of a port of this computer that mean no good, all at once: a quarter connects and says
 * nothing, one sends half a request, one garbage, and one message after message, many on each
 * connection.
 */
final class Crowd implements AutoCloseable {
  private static final int KINDS = 4;
  private static final int AT_ONCE = 50;
  private static final int PATIENCE_MS = 5000;
  private static final long BREATH_MS = 100;

  private final int port;
  private final long messagesEach;
  private final String message;
  private final List<Thread> clients = new ArrayList<>();
  private final List<Thread> talkers = new ArrayList<>();
  private final AtomicLong sent = new AtomicLong();
  private volatile boolean ended;

  /**
   * Begins.
   *
   * @param clients how many
   * @param messages how many in all
   */
  Crowd(int port, int clients, long messages) {
    this.port = port;
    messagesEach = messages * KINDS / clients;
    message = "GET /catalogue?token=0 HTTP/1.1\r\nHost: localhost:" + port + "\r\n\r\n";
    for (int i = 0; i < clients; i++) {
      int kind = i % KINDS;
      Thread client = new Thread(() -> live(kind), "crowd");
      client.setDaemon(true);
      this.clients.add(client);
      if (kind == KINDS - 1) {
        talkers.add(client);
      }
    }
    this.clients.forEach(Thread::start);
  }

  /** How many messages were sent until now. */
  long sent() {
    return sent.get();
  }

  /** Whether somebody still has messages to send. */
  boolean talks() {
    return talkers.stream().anyMatch(Thread::isAlive);
  }

  private void live(int kind) {
    long left = messagesEach;
    while (!ended && left > 0) {
      try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
        socket.setSoTimeout(PATIENCE_MS);
        switch (kind) {
          case 0 -> {}
          case 1 -> say(socket, "GET / HT");
          case 2 -> say(socket, "\u0000\u0001\u00ff".repeat(100) + "\r\n");
          default -> {
            say(socket, message.repeat(AT_ONCE));
            sent.addAndGet(AT_ONCE);
            left -= AT_ONCE;
          }
        }
        hear(socket);
      } catch (IOException e) {
        // It is thrown out, or nobody takes it in: it comes again.
        breathe();
      }
    }
  }

  private static void say(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    socket.getOutputStream().flush();
  }

  private static void hear(Socket socket) throws IOException {
    InputStream in = socket.getInputStream();
    byte[] answer = new byte[4096];
    while (in.read(answer) >= 0) {
      // Until it is told to go.
    }
  }

  private static void breathe() {
    try {
      Thread.sleep(BREATH_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** They go as soon as they notice. */
  @Override
  public void close() {
    ended = true;
  }
}
