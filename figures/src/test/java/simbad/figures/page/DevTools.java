package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
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
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** A page in headless Chromium, asked by the DevTools protocol. */
public final class DevTools implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String LISTENING = "DevTools listening on ";
  private static final long PATIENCE_S = 60;
  private static final long BLINK_MS = 50;

  private final Process chromium;
  private final WebSocket socket;
  private final BlockingQueue<String> answers;
  private int number;

  private DevTools(Process chromium, WebSocket socket, BlockingQueue<String> answers) {
    this.chromium = chromium;
    this.socket = socket;
    this.answers = answers;
  }

  /** Opens a page in a browser whose files go to the folder. */
  public static DevTools before(URI page, Path folder) throws Exception {
    List<String> command = new ArrayList<>(new Browser(folder).command(page, 1280, false));
    command.add("--remote-debugging-port=0");
    Process chromium = new ProcessBuilder(command).redirectErrorStream(true).start();
    HttpClient client = HttpClient.newHttpClient();
    URI browser = listening(chromium);
    BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    WebSocket socket =
        client.newWebSocketBuilder().buildAsync(tab(client, browser), new Ear(answers)).join();
    return new DevTools(chromium, socket, answers);
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

  /** Calls a method and returns its result. */
  public JsonNode ask(String method, ObjectNode parameters) throws Exception {
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

  /** What an expression is on the page, as text; a promise is awaited. */
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

  /** The window as a picture in PNG. */
  public byte[] picture() throws Exception {
    String data = ask("Page.captureScreenshot", MAPPER.createObjectNode()).path("data").asText();
    return Base64.getDecoder().decode(data);
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
