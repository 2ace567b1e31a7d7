package simbad.studio.bench;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Map;
import java.util.function.Supplier;
import simbad.studio.web.Content;
import simbad.studio.web.Guard;
import simbad.studio.web.PageFiles;
import simbad.studio.web.WebServer;

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
    Guard guard = Guard.of(address.getAddress());
    Map<String, Supplier<Content>> answers = PageFiles.of(guard, Map.of("/", "bench.html"));
    answers.put("/state", () -> Content.json(state.json()));
    return new LivePage(WebServer.open(address, guard, answers, Map.of()));
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
