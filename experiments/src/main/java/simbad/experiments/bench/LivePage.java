package simbad.experiments.bench;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * A page on this computer that shows a sweep as it goes on. It only shows: nothing that is sent to
 * it changes anything. At another address than the loopback, it shows to nobody without the token.
 */
public final class LivePage implements AutoCloseable {
  private static final int OK = 200;
  private static final int FORBIDDEN = 403;
  private static final int NOT_FOUND = 404;
  private static final int NOT_ALLOWED = 405;
  private static final int TOKEN_BYTES = 16;
  private static final Set<String> LOCAL_NAMES = Set.of("localhost", "127.0.0.1", "[::1]");

  private final HttpServer server;
  private final ExecutorService threads = Executors.newFixedThreadPool(2, LivePage::thread);
  private final LiveState state;
  private final Optional<String> token;
  private final byte[] page;

  private LivePage(HttpServer server, LiveState state, Optional<String> token, byte[] page) {
    this.server = server;
    this.state = state;
    this.token = token;
    this.page = page;
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "page of the sweep");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Opens the page.
   *
   * @param address where; port 0 for any that is free
   * @param state what it shows
   * @throws IOException if the address is taken or none of this computer's
   */
  public static LivePage open(InetSocketAddress address, LiveState state) throws IOException {
    HttpServer server;
    try {
      server = HttpServer.create(address, 0);
    } catch (IOException e) {
      throw new IOException("page at " + address + ": " + e.getMessage(), e);
    }
    InetAddress at = server.getAddress().getAddress();
    Optional<String> token = at.isLoopbackAddress() ? Optional.empty() : Optional.of(token());
    byte[] page;
    try (InputStream in = Objects.requireNonNull(LivePage.class.getResourceAsStream("live.html"))) {
      page = in.readAllBytes();
    }
    LivePage live = new LivePage(server, state, token, page);
    server.createContext("/", live::answer);
    server.setExecutor(live.threads);
    server.start();
    return live;
  }

  private static String token() {
    byte[] bytes = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(bytes);
    return HexFormat.of().formatHex(bytes);
  }

  /** Returns the page's address, with the token that it asks for. */
  public String url() {
    InetSocketAddress at = server.getAddress();
    return "http://"
        + host(at.getAddress())
        + ":"
        + at.getPort()
        + "/"
        + token.map(secret -> "?token=" + secret).orElse("");
  }

  /** Where every address of this computer will do, the nearest one is named. */
  private static String host(InetAddress address) {
    if (address.isLoopbackAddress() || address.isAnyLocalAddress()) {
      return "localhost";
    }
    String text = address.getHostAddress();
    return text.indexOf(':') < 0 ? text : "[" + text + "]";
  }

  private void answer(HttpExchange exchange) throws IOException {
    try (exchange) {
      String path = exchange.getRequestURI().getPath();
      if (!isAllowed(exchange)) {
        send(exchange, FORBIDDEN, "text/plain", "forbidden".getBytes(StandardCharsets.UTF_8));
      } else if (!exchange.getRequestMethod().equals("GET")) {
        send(exchange, NOT_ALLOWED, "text/plain", "only GET".getBytes(StandardCharsets.UTF_8));
      } else if (path.equals("/")) {
        send(exchange, OK, "text/html; charset=utf-8", page);
      } else if (path.equals("/state")) {
        send(exchange, OK, "application/json", state.json().getBytes(StandardCharsets.UTF_8));
      } else {
        send(exchange, NOT_FOUND, "text/plain", "not found".getBytes(StandardCharsets.UTF_8));
      }
    }
  }

  /** A page of another site that has this computer's address under a name of its own is refused. */
  private boolean isAllowed(HttpExchange exchange) {
    if (token.isPresent()) {
      String query = String.valueOf(exchange.getRequestURI().getQuery());
      return MessageDigest.isEqual(
          query.getBytes(StandardCharsets.UTF_8),
          ("token=" + token.get()).getBytes(StandardCharsets.UTF_8));
    }
    String host = String.valueOf(exchange.getRequestHeaders().getFirst("Host"));
    return LOCAL_NAMES.contains(host.replaceFirst(":\\d+$", ""));
  }

  private static void send(HttpExchange exchange, int status, String type, byte[] body)
      throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.getResponseHeaders().set("Cache-Control", "no-store");
    exchange.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
    exchange
        .getResponseHeaders()
        .set(
            "Content-Security-Policy",
            "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline';"
                + " connect-src 'self'");
    exchange.sendResponseHeaders(status, body.length);
    exchange.getResponseBody().write(body);
  }

  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
