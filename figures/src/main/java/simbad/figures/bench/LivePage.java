package simbad.figures.bench;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Objects;
import simbad.figures.web.Content;
import simbad.figures.web.PagePolicy;
import simbad.figures.web.WebServer;

/**
 * A page on this computer that shows a sweep as it goes on. It only shows: nothing that is sent to
 * it changes anything. At another address than the loopback, it shows to nobody without the token.
 */
public final class LivePage implements AutoCloseable {
  private final WebServer server;

  private LivePage(WebServer server) {
    this.server = server;
  }

  /**
   * Opens the page.
   *
   * @param address where; port 0 for any that is free
   * @param state what it shows
   * @throws IOException if the address is taken or none of this computer's
   */
  public static LivePage open(InetSocketAddress address, LiveState state) throws IOException {
    String page = page();
    return new LivePage(
        WebServer.open(
            address,
            PagePolicy.of(page),
            Map.of("/", () -> Content.html(page), "/state", () -> Content.json(state.json()))));
  }

  private static String page() throws IOException {
    try (InputStream in = Objects.requireNonNull(LivePage.class.getResourceAsStream("live.html"))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Returns the page's address, with the token that it asks for. */
  public String url() {
    return server.url();
  }

  @Override
  public void close() {
    server.close();
  }
}
