package simbad.studio;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import simbad.experiments.run.SensorKind;
import simbad.figures.web.Content;
import simbad.figures.web.PagePolicy;
import simbad.figures.web.WebServer;
import simbad.sonar.format.DataFormatException;

/**
 * The live page on this computer. Who has its address, which holds a token, may ask for worlds;
 * nothing that is asked changes a file or outlives the page.
 */
public final class Studio implements AutoCloseable {
  private final WebServer server;

  private Studio(WebServer server) {
    this.server = server;
  }

  /**
   * Opens the page.
   *
   * @param address where; port 0 for any that is free
   * @param sensors that can be chosen, the first at the beginning; names distinct
   * @throws IOException if the address is taken or none of this computer's
   * @throws DataFormatException if an obstacle of the user's own cannot be read
   */
  public static Studio open(InetSocketAddress address, List<SensorKind> sensors)
      throws IOException, DataFormatException {
    String page = page();
    String catalogue = CatalogueJson.of(sensors);
    Worlds worlds = new Worlds(sensors);
    return new Studio(
        WebServer.openWithToken(
            address,
            PagePolicy.of(page),
            Map.of("/", () -> Content.html(page), "/catalogue", () -> Content.json(catalogue)),
            Map.of("/frames", question -> answer(worlds, question))));
  }

  private static Content answer(Worlds worlds, String question) {
    try {
      return Content.json(worlds.frames(question));
    } catch (DataFormatException e) {
      String fault = String.valueOf(e.getMessage());
      return Content.json(JsonNodeFactory.instance.objectNode().put("fault", fault).toString());
    }
  }

  private static String page() throws IOException {
    try (InputStream in = Objects.requireNonNull(Studio.class.getResourceAsStream("studio.html"))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Returns the page's address with its token. */
  public String url() {
    return server.url();
  }

  /** Ends the page; a question that is being answered ends unanswered. */
  @Override
  public void close() {
    server.close();
  }
}
