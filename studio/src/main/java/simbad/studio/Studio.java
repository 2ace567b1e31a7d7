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
import simbad.studio.bench.LiveState;
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
  /** The page's view of a capture that goes on. */
  private static final String WATCHED = "#capture";

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
    Optional<Opening> shown = folders.map(known -> () -> known);
    return serve(
        address,
        worlds,
        CatalogueJson.of(choices, opened),
        new Shown(shown, Optional.empty()),
        folders.isPresent() && scene.isEmpty() ? "#folders" : "");
  }

  /**
   * Opens the page at a capture that this program makes.
   *
   * @param address where; port 0 for any that is free
   * @param folder of the capture, which may not be there yet
   * @param capture how far it is
   * @throws IOException if the address is taken or none of this computer's
   * @throws DataFormatException if an obstacle of the user's own cannot be read
   */
  public static Studio ofCapture(InetSocketAddress address, Path folder, LiveState capture)
      throws IOException, DataFormatException {
    Choices choices = Choices.plain();
    Opening shown = new LateFolders(folder)::get;
    return serve(
        address,
        new Worlds(choices),
        CatalogueJson.of(choices, Optional.empty()),
        new Shown(Optional.of(shown), Optional.of(capture)),
        WATCHED);
  }

  /** What is shown besides the live world. */
  private record Shown(Optional<Opening> folders, Optional<LiveState> capture) {}

  /** Folders: those of a capture are there as soon as it has begun. */
  @FunctionalInterface
  private interface Opening {
    Folders folders() throws DataFormatException;
  }

  private static Studio serve(
      InetSocketAddress address, Worlds worlds, String catalogue, Shown shown, String view)
      throws IOException {
    Guard guard = Guard.of(address.getAddress());
    Map<String, Supplier<Content>> answers = PageFiles.of(guard, Map.of("/", "index.html"));
    answers.put("/catalogue", () -> Content.json(catalogue));
    String views = "{\"capture\":" + shown.capture().isPresent() + "}";
    answers.put("/views", () -> Content.json(views));
    answers.put("/folders", () -> answer("", all -> list(shown)));
    Map<String, Function<String, Content>> questions = new HashMap<>();
    questions.put("/frames", question -> answer(question, worlds::frames));
    questions.put("/loudness", question -> answer(question, worlds::loudness));
    Map<String, Function<String, String>> streams = new HashMap<>();
    streams.put("/watch", path -> said(path, of -> watched(shown, of)));
    shown
        .folders()
        .ifPresent(
            opening -> {
              questions.put(
                  "/folder", question -> answer(question, of -> opening.folders().open(of)));
              questions.put(
                  "/trace", question -> answer(question, of -> opening.folders().trace(of)));
            });
    return new Studio(
        WebServer.open(address, guard, new WebServer.Answers(answers, questions, streams)), view);
  }

  private static String list(Shown shown) throws DataFormatException {
    return shown.folders().isPresent() ? shown.folders().get().folders().list() : "{}";
  }

  /** How far a capture is: one in a folder, or without a name this program's own. */
  private static String watched(Shown shown, String path) throws DataFormatException {
    if (path.isEmpty() && shown.capture().isPresent()) {
      return shown.capture().get().json();
    }
    if (shown.folders().isEmpty()) {
      throw DataFormatException.inArgument("path", "no capture is shown here");
    }
    return shown.folders().get().folders().capture(path);
  }

  /** What is answered to a question. */
  @FunctionalInterface
  private interface Answering {
    String to(String question) throws DataFormatException;
  }

  private static Content answer(String question, Answering answering) {
    return Content.json(said(question, answering));
  }

  private static String said(String question, Answering answering) {
    try {
      return answering.to(question);
    } catch (DataFormatException e) {
      String fault = String.valueOf(e.getMessage());
      return JsonNodeFactory.instance.objectNode().put("fault", fault).toString();
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
