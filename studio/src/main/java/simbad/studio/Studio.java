package simbad.studio;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import simbad.sonar.format.DataFormatException;
import simbad.studio.folders.Folders;
import simbad.studio.web.Content;
import simbad.studio.web.Guard;
import simbad.studio.web.PageFiles;
import simbad.studio.web.WebServer;

/**
 * The live page on this computer. Who has its address, which holds a token, may ask for worlds;
 * nothing that is asked changes a file or outlives the page.
 */
public final class Studio implements AutoCloseable {
  private final WebServer server;
  private final String view;

  private Studio(WebServer server, String view) {
    this.server = server;
    this.view = view;
  }

  /**
   * Opens the page.
   *
   * @param address where; port 0 for any that is free
   * @param choices what a world can be made of
   * @param folders what is shown besides the live world; empty for nothing
   * @throws IOException if the address is taken or none of this computer's
   * @throws DataFormatException if an obstacle of the user's own cannot be read
   */
  public static Studio open(InetSocketAddress address, Choices choices, Optional<Folders> folders)
      throws IOException, DataFormatException {
    return open(address, choices, folders, Optional.empty());
  }

  /**
   * Opens the page at a scene that was saved on it.
   *
   * @param address where; port 0 for any that is free
   * @param choices what a world can be made of
   * @param folders what is shown besides the live world; empty for nothing
   * @param scene its file; empty for the page's own
   * @throws IOException if the address is taken or none of this computer's
   * @throws DataFormatException if an obstacle of the user's own cannot be read, or the scene is
   *     none that the choices make
   */
  public static Studio open(
      InetSocketAddress address, Choices choices, Optional<Folders> folders, Optional<Path> scene)
      throws IOException, DataFormatException {
    Worlds worlds = new Worlds(choices);
    Optional<String> opened =
        scene.isPresent() ? Optional.of(worlds.scene(scene.get())) : Optional.empty();
    Guard guard = Guard.withToken(address.getAddress());
    Map<String, Supplier<Content>> answers =
        PageFiles.of(guard, Map.of("/", "index.html", "/bench", "bench.html"));
    String catalogue = CatalogueJson.of(choices, opened);
    answers.put("/catalogue", () -> Content.json(catalogue));
    answers.put(
        "/folders", () -> answer("", none -> folders.isPresent() ? folders.get().list() : "{}"));
    Map<String, Function<String, Content>> questions = new HashMap<>();
    questions.put("/frames", question -> answer(question, worlds::frames));
    questions.put("/loudness", question -> answer(question, worlds::loudness));
    folders.ifPresent(
        shown -> {
          questions.put("/folder", question -> answer(question, shown::open));
          questions.put("/trace", question -> answer(question, shown::trace));
          questions.put("/capture", question -> answer(question, shown::capture));
        });
    return new Studio(
        WebServer.open(address, guard, answers, questions),
        folders.isPresent() && scene.isEmpty() ? "#folders" : "");
  }

  /** What is answered to a question. */
  @FunctionalInterface
  private interface Answering {
    String to(String question) throws DataFormatException;
  }

  private static Content answer(String question, Answering answering) {
    try {
      return Content.json(answering.to(question));
    } catch (DataFormatException e) {
      String fault = String.valueOf(e.getMessage());
      return Content.json(JsonNodeFactory.instance.objectNode().put("fault", fault).toString());
    }
  }

  /** Returns the page's address with its token; with a folder it opens that first. */
  public String url() {
    return server.url() + view;
  }

  /** Ends the page; a question that is being answered ends unanswered. */
  @Override
  public void close() {
    server.close();
  }
}
