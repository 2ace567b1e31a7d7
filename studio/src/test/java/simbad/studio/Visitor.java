package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.deque.html.axecore.selenium.AxeBuilder;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** Somebody with mouse and keyboard before a page in headless Chromium (DevTools protocol). */
public final class Visitor implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String LISTENING = "DevTools listening on ";
  private static final long PATIENCE_S = 60;
  private static final Optional<Path> CHROMIUM =
      Stream.of(System.getenv("PATH").split(File.pathSeparator, -1))
          .flatMap(
              folder ->
                  Stream.of("chromium", "chromium-browser", "google-chrome")
                      .map(name -> Path.of(folder, name)))
          .filter(Files::isExecutable)
          .findFirst();

  private final Process chromium;
  private final WebSocket socket;
  private final BlockingQueue<String> answers;
  private int number;

  private Visitor(Process chromium, WebSocket socket, BlockingQueue<String> answers) {
    this.chromium = chromium;
    this.socket = socket;
    this.answers = answers;
  }

  public static boolean isThere() {
    return CHROMIUM.isPresent();
  }

  public static Visitor at(String page, Path folder) throws Exception {
    List<String> command =
        List.of(
            CHROMIUM.orElseThrow().toString(),
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--disable-dev-shm-usage",
            "--user-data-dir=" + Files.createTempDirectory(folder, "profile"),
            "--window-size=1280,800",
            "--remote-debugging-port=0",
            page);
    Process chromium = new ProcessBuilder(command).redirectErrorStream(true).start();
    HttpClient client = HttpClient.newHttpClient();
    URI browser = listening(chromium);
    BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    WebSocket socket =
        client.newWebSocketBuilder().buildAsync(tab(client, browser), new Ear(answers)).join();
    return new Visitor(chromium, socket, answers);
  }

  private static URI listening(Process chromium) throws IOException {
    BufferedReader lines = chromium.inputReader(StandardCharsets.UTF_8);
    String line = lines.readLine();
    while (line != null && !line.startsWith(LISTENING)) {
      line = lines.readLine();
    }
    // What it says later is read, lest it waits for a reader.
    Thread reader = new Thread(() -> lines.lines().forEach(rest -> {}));
    reader.setDaemon(true);
    reader.start();
    assertTrue(line != null, "Chromium ended");
    return URI.create(String.valueOf(line).substring(LISTENING.length()));
  }

  private static URI tab(HttpClient client, URI browser) throws Exception {
    URI list = URI.create("http://" + browser.getAuthority() + "/json/list");
    String text = client.send(HttpRequest.newBuilder(list).build(), BodyHandlers.ofString()).body();
    for (JsonNode target : MAPPER.readTree(text)) {
      if (target.path("type").asText().equals("page")) {
        return URI.create(target.path("webSocketDebuggerUrl").asText());
      }
    }
    throw new AssertionError("no page: " + text);
  }

  /** Hears what the browser answers. */
  private record Ear(StringBuilder begun, BlockingQueue<String> answers)
      implements WebSocket.Listener {
    Ear(BlockingQueue<String> answers) {
      this(new StringBuilder(), answers);
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket socket, CharSequence part, boolean last) {
      begun.append(part);
      if (last) {
        answers.add(begun.toString());
        begun.setLength(0);
      }
      socket.request(1);
      return null;
    }
  }

  private JsonNode ask(String method, String parameters) throws Exception {
    int id = ++number;
    ObjectNode call = MAPPER.createObjectNode().put("id", id).put("method", method);
    call.set("params", MAPPER.readTree(parameters));
    socket.sendText(call.toString(), true).join();
    while (true) {
      String answer = answers.poll(PATIENCE_S, TimeUnit.SECONDS);
      assertTrue(answer != null, method + ": no answer");
      JsonNode json = MAPPER.readTree(answer);
      if (json.path("id").asInt() == id) {
        return json.path("result");
      }
    }
  }

  /** The window's size in pixels, and the theme. */
  public void resize(int width, int height, boolean dark) throws Exception {
    ask(
        "Emulation.setDeviceMetricsOverride",
        "{\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":false}"
            .formatted(width, height));
    ask(
        "Emulation.setEmulatedMedia",
        "{\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"%s\"}]}"
            .formatted(dark ? "dark" : "light"));
  }

  /** Presses and lets go a key: a character, or an arrow with Windows' number of it. */
  public void press(String key, int code) throws Exception {
    String text = key.length() == 1 ? ",\"text\":\"" + key + "\"" : "";
    String rest = "\"key\":\"%s\",\"windowsVirtualKeyCode\":%d%s}".formatted(key, code, text);
    ask("Input.dispatchKeyEvent", "{\"type\":\"keyDown\"," + rest);
    ask("Input.dispatchKeyEvent", "{\"type\":\"keyUp\"," + rest);
  }

  /** Clicks the middle of what a selector finds. */
  public void click(String selector) throws Exception {
    look("document.querySelector('" + selector + "').scrollIntoView({block: 'center'})");
    JsonNode at =
        MAPPER.readTree(
            look(
                "{const b = document.querySelector('"
                    + selector
                    + "').getBoundingClientRect();"
                    + " JSON.stringify([b.x + b.width / 2, b.y + b.height / 2])}"));
    drag(at.get(0).asDouble(), at.get(1).asDouble(), 0, 0);
  }

  /** Presses at a place of the window, goes some pixels, lets go. */
  public void drag(double x, double y, double byX, double byY) throws Exception {
    mouse("mouseMoved", x, y);
    mouse("mousePressed", x, y);
    if (byX != 0 || byY != 0) {
      mouse("mouseMoved", x + byX / 2, y + byY / 2);
      mouse("mouseMoved", x + byX, y + byY);
    }
    mouse("mouseReleased", x + byX, y + byY);
  }

  public void mouse(String type, double x, double y) throws Exception {
    String button = type.equals("mouseMoved") ? "none" : "left";
    ask(
        "Input.dispatchMouseEvent",
        "{\"type\":\"%s\",\"x\":%s,\"y\":%s,\"button\":\"%s\",\"clickCount\":1}"
            .formatted(type, x, y, button));
  }

  /** What an expression is on the page, as text; a promise is awaited. */
  public String look(String expression) throws Exception {
    ObjectNode parameters =
        MAPPER
            .createObjectNode()
            .put("expression", expression)
            .put("awaitPromise", true)
            .put("returnByValue", true);
    return ask("Runtime.evaluate", parameters.toString()).path("result").path("value").asText();
  }

  /** Waits until an expression is true; what it never became is said. */
  public void await(String expression) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!look(expression).equals("true")) {
      assertTrue(System.nanoTime() < end, "in vain: " + expression);
      Thread.sleep(30);
    }
  }

  /** What axe-core, an accessibility checker, finds wrong. */
  public String violations() throws Exception {
    try (InputStream in =
        Objects.requireNonNull(AxeBuilder.class.getResourceAsStream("/axe.min.js"))) {
      look(new String(in.readAllBytes(), StandardCharsets.UTF_8) + ";1");
    }
    return look(
        "axe.run().then(r => JSON.stringify(r.violations.map(v => v.id + ' ' + v.nodes.map(n => n.html))))");
  }

  /** The window as a picture in PNG. */
  public byte[] picture() throws Exception {
    return Base64.getDecoder().decode(ask("Page.captureScreenshot", "{}").path("data").asText());
  }

  /** Ends the browser with all its processes: one that is left still writes into the folder. */
  @Override
  public void close() {
    List<ProcessHandle> all = new ArrayList<>(chromium.descendants().toList());
    all.add(chromium.toHandle());
    socket.abort();
    all.forEach(ProcessHandle::destroyForcibly);
    all.forEach(process -> process.onExit().join());
  }
}
