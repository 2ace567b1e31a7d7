package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;

/**
 * Somebody at the keyboard before a page in Chromium: keys go the way of real ones (DevTools
 * protocol, Input.dispatchKeyEvent), so that the browser's own doings with them happen as well.
 */
public final class Typist implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String LISTENING = "DevTools listening on ";
  private static final long PATIENCE_S = 60;
  private static final long BLINK_MS = 50;

  /** Windows' numbers of keys that type nothing. */
  private static final Map<String, Integer> CODES =
      Map.of(
          "Tab",
          9,
          "Enter",
          13,
          "Escape",
          27,
          "End",
          35,
          "Home",
          36,
          "ArrowLeft",
          37,
          "ArrowUp",
          38,
          "ArrowRight",
          39,
          "ArrowDown",
          40);

  private final Process chromium;
  private final WebSocket socket;
  private final BlockingQueue<String> answers;
  private int number;

  private Typist(Process chromium, WebSocket socket, BlockingQueue<String> answers) {
    this.chromium = chromium;
    this.socket = socket;
    this.answers = answers;
  }

  /** Opens a page in a browser whose files go to the folder. */
  public static Typist before(URI page, Path folder) throws Exception {
    List<String> command = new ArrayList<>(new Browser(folder).command(page, 1280, false));
    command.add("--remote-debugging-port=0");
    Process chromium = new ProcessBuilder(command).redirectErrorStream(true).start();
    HttpClient client = HttpClient.newHttpClient();
    URI browser = listening(chromium);
    BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    WebSocket socket =
        client.newWebSocketBuilder().buildAsync(tab(client, browser), new Ear(answers)).join();
    return new Typist(chromium, socket, answers);
  }

  /** What it says later is read, lest it waits for a reader. */
  private static URI listening(Process chromium) throws IOException {
    BufferedReader lines = chromium.inputReader(StandardCharsets.UTF_8);
    String line = lines.readLine();
    while (line != null && !line.startsWith(LISTENING)) {
      line = lines.readLine();
    }
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

  private JsonNode ask(String method, ObjectNode parameters) throws Exception {
    int id = ++number;
    ObjectNode call = MAPPER.createObjectNode().put("id", id).put("method", method);
    call.set("params", parameters);
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

  /** Shows another page. */
  public void open(URI page) throws Exception {
    ask("Page.navigate", MAPPER.createObjectNode().put("url", page.toString()));
    await("location.href === '" + page + "' && document.readyState === 'complete'");
  }

  /** Gives the page so many pixels to the right and a theme. */
  public void show(int width, boolean dark) throws Exception {
    resize(width, 800);
    ObjectNode media = MAPPER.createObjectNode().put("media", "");
    media
        .putArray("features")
        .addObject()
        .put("name", "prefers-color-scheme")
        .put("value", dark ? "dark" : "light");
    ask("Emulation.setEmulatedMedia", media);
  }

  /** Makes the page look as it is printed. */
  public void print() throws Exception {
    ask("Emulation.setEmulatedMedia", MAPPER.createObjectNode().put("media", "print"));
  }

  /** Lets scripts run in pages that are opened from now on, or not. */
  public void allowScripts(boolean allowed) throws Exception {
    ask("Emulation.setScriptExecutionDisabled", MAPPER.createObjectNode().put("value", !allowed));
  }

  /** Goes with the mouse to the middle of what a selector finds, which is scrolled into sight. */
  public void pointAt(String selector) throws Exception {
    look("document.querySelector('" + selector + "').scrollIntoView({block: 'center'})");
    ask("Input.dispatchMouseEvent", mouse("mouseMoved", middle(selector)));
  }

  /** Turns the wheel over the middle of what a selector finds. */
  public void wheel(String selector, double delta) throws Exception {
    pointAt(selector);
    double[] at = middle(selector);
    ask("Input.dispatchMouseEvent", mouse("mouseWheel", at).put("deltaX", 0).put("deltaY", delta));
  }

  private double[] middle(String selector) throws Exception {
    String box = "document.querySelector('" + selector + "').getBoundingClientRect()";
    return new double[] {
      Double.parseDouble(look(box + ".x + " + box + ".width / 2")),
      Double.parseDouble(look(box + ".y + " + box + ".height / 2"))
    };
  }

  private static ObjectNode mouse(String type, double... at) {
    return MAPPER.createObjectNode().put("type", type).put("x", at[0]).put("y", at[1]);
  }

  /** What a reader would see amiss on the page: a list in brackets, empty when nothing is. */
  public String faults() throws Exception {
    look(Browser.axe());
    return look(Browser.PROBE);
  }

  /** What is in sight. */
  public BufferedImage picture() throws Exception {
    String data = ask("Page.captureScreenshot", MAPPER.createObjectNode()).path("data").asText();
    return ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(data)));
  }

  /** Makes the page as large as that in pixels. */
  public void resize(int width, int height) throws Exception {
    ObjectNode size = MAPPER.createObjectNode().put("width", width).put("height", height);
    ask(
        "Emulation.setDeviceMetricsOverride",
        size.put("deviceScaleFactor", 1).put("mobile", false));
  }

  /** Presses and lets go a key: a character, or one that types nothing. */
  public void press(String key) throws Exception {
    ObjectNode down = MAPPER.createObjectNode().put("type", "keyDown").put("key", key);
    ObjectNode up = MAPPER.createObjectNode().put("type", "keyUp").put("key", key);
    if (CODES.containsKey(key)) {
      down.put("code", key).put("windowsVirtualKeyCode", CODES.get(key));
      up.put("code", key).put("windowsVirtualKeyCode", CODES.get(key));
    }
    if (key.length() == 1 || key.equals("Enter")) {
      down.put("text", key.equals("Enter") ? "\r" : key);
    }
    ask("Input.dispatchKeyEvent", down);
    ask("Input.dispatchKeyEvent", up);
  }

  public void type(String text) throws Exception {
    for (int i = 0; i < text.length(); i++) {
      press(text.substring(i, i + 1));
    }
  }

  /** What an expression is on the page, as text. */
  public String look(String expression) throws Exception {
    ObjectNode parameters = MAPPER.createObjectNode().put("expression", expression);
    return ask("Runtime.evaluate", parameters.put("returnByValue", true).put("awaitPromise", true))
        .path("result")
        .path("value")
        .asText();
  }

  /** Waits until an expression is true; what it never became is said. */
  public void await(String expression) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!look(expression).equals("true")) {
      assertTrue(System.nanoTime() < end, "in vain: " + expression);
      Thread.sleep(BLINK_MS);
    }
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
