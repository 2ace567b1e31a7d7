package simbad.studio.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WebServerTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();
  private static final String PAGE = "<p>a page</p>";
  // More than the sockets hold.
  private static final String LARGE = "x".repeat(5_000_000);
  private static final Map<String, Supplier<Content>> ANSWERS =
      Map.of(
          "/",
          () -> Content.html(PAGE),
          "/state",
          () -> Content.json("{\"a\":1}"),
          "/large",
          () -> Content.html(LARGE),
          "/broken",
          () -> {
            throw new IllegalStateException("secret");
          });

  /** What is followed; always another one, and large. */
  private final Iterator<String> news =
      Stream.iterate(0, i -> i + 1).map(i -> i + LARGE).iterator();

  private final List<Socket> sockets = new ArrayList<>();

  // Opened before each test.
  @SuppressWarnings("NullAway.Init")
  private WebServer server;

  @BeforeEach
  void open() throws IOException {
    server = open("127.0.0.1", 0);
  }

  @AfterEach
  void close() throws IOException {
    server.close();
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  private WebServer open(String address, int port) throws IOException {
    InetSocketAddress at = new InetSocketAddress(address, port);
    return WebServer.open(
        at,
        Guard.of(at.getAddress()),
        new WebServer.Answers(
            ANSWERS,
            Map.of(),
            Map.of("/news", path -> path.isEmpty() ? nextNews() : "of " + path)));
  }

  /** Where a path is answered. */
  private static String at(WebServer server, String path) {
    return server.url().replace("/?", "/" + path + "?");
  }

  private String at(String path) {
    return at(server, path);
  }

  private String query() {
    return "?" + URI.create(server.url()).getQuery();
  }

  private synchronized String nextNews() {
    return news.next();
  }

  private int port() {
    return URI.create(server.url()).getPort();
  }

  private static HttpResponse<String> ask(String method, String url) throws Exception {
    return HttpClient.newHttpClient()
        .send(
            HttpRequest.newBuilder(URI.create(url))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .timeout(Duration.ofMinutes(1))
                .build(),
            HttpResponse.BodyHandlers.ofString());
  }

  /** Sends as it stands, and does not read. */
  private Socket send(String text) throws IOException {
    Socket socket = new Socket();
    sockets.add(socket);
    socket.setReceiveBufferSize(1024);
    socket.setSoTimeout(60_000);
    socket.connect(new InetSocketAddress(HERE, port()));
    socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  private String answer(String text) throws IOException {
    return new String(send(text).getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  private void checkAnswers() throws Exception {
    assertEquals("{\"a\":1}", ask("GET", at("state")).body());
  }

  @Test
  void unfinishedRequests_keepNobodyOut() throws Exception {
    for (int i = 0; i < 300; i++) {
      send("GET /state" + query() + " HTTP/1.1\r\nHost: localhost\r\nX-" + i + ": ");
    }
    checkAnswers();
    assertEquals(-1, sockets.get(0).getInputStream().read(), "the eldest made room");
  }

  @Test
  void silentConnections_keepNobodyOut() throws Exception {
    for (int i = 0; i < 300; i++) {
      send("");
    }
    checkAnswers();
  }

  /** Each keeps a thread busy with writing. */
  @Test
  void answersThatNobodyReads_keepNobodyOut() throws Exception {
    for (int i = 0; i < 150; i++) {
      send("GET /large" + query() + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
      checkAnswers();
    }
  }

  /** Nobody waits for a follower: the eldest of too many gives way, though it hangs in a write. */
  @Test
  void followersThatNeverRead_keepNobodyOut() throws Exception {
    String follow = "GET /news" + query() + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    Socket eldest = send(follow);
    // It follows as soon as it is answered; of those that come at once any may be the eldest.
    assertEquals('H', eldest.getInputStream().read());
    for (int i = 1; i < 100; i++) {
      send(follow);
    }
    checkAnswers();
    assertTrue(eldest.getInputStream().readAllBytes().length < LARGE.length(), "cut off");
  }

  /** The address may say what is followed, behind the token; each new state is an event. */
  @Test
  void follower_isToldWhatItsAddressNames() throws Exception {
    Socket socket = send("GET /news" + query() + "&path=a%2Fb HTTP/1.1\r\nHost: localhost\r\n\r\n");
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
    String told = lines.lines().filter(line -> line.startsWith("data: ")).findFirst().orElse("");
    assertEquals("data: of a/b", told);
  }

  /** A connection serves one request, so that none outlives its time by sending one more. */
  @Test
  void connection_endsWithItsAnswer() throws Exception {
    String request = "GET /state" + query() + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    assertEquals(2, answer(request + request).split("HTTP/1.1 200", -1).length);
  }

  /** A drop of a request at a time does not keep it alive. */
  @Test
  void drippingRequest_isCutOff() throws Exception {
    Socket socket = send("GET /state" + query() + " HTTP/1.1\r\nHost: localhost\r\n");
    assertThrows(
        IOException.class,
        () -> {
          for (int i = 0; i < 600; i++) {
            socket.getOutputStream().write("X: y\r\n".getBytes(StandardCharsets.US_ASCII));
            Thread.sleep(100);
          }
        });
  }

  /** Nothing of it may come among what an operator reads. */
  @Test
  void terminal_isLeftAlone() throws Exception {
    List<String> logged = new ArrayList<>();
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    PrintStream before = System.err;
    Handler handler = keeping(logged);
    Logger.getLogger("").addHandler(handler);
    System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try (WebServer other = open("127.0.0.1", 0)) {
      HttpResponse<String> head = ask("HEAD", other.url());
      assertEquals(200, head.statusCode());
      assertEquals("", head.body());
      ask("GET", at(other, "broken"));
      ask("GET", at(other, "x").repeat(100_000));
      answer("NONSENSE\r\n\r\n");
    } finally {
      System.setErr(before);
      Logger.getLogger("").removeHandler(handler);
    }
    assertEquals("", printed.toString(StandardCharsets.UTF_8));
    assertEquals(List.of(), logged);
  }

  private static Handler keeping(List<String> logged) {
    return new Handler() {
      @Override
      public void publish(LogRecord entry) {
        if (!String.valueOf(entry.getLoggerName()).startsWith("org.junit")) {
          logged.add(entry.getLoggerName() + ": " + entry.getMessage());
        }
      }

      @Override
      public void flush() {}

      @Override
      public void close() {}
    };
  }

  @Test
  void head_isWhatGetWouldBe_withoutTheBody() throws Exception {
    HttpResponse<String> head = ask("HEAD", server.url());
    HttpResponse<String> get = ask("GET", server.url());
    assertEquals("", head.body());
    for (String field : List.of("Content-Type", "Content-Length", "Content-Security-Policy")) {
      assertEquals(get.headers().firstValue(field), head.headers().firstValue(field), field);
    }
    assertEquals(404, ask("HEAD", at("none")).statusCode());
  }

  @Test
  void fault_isNotExplained() throws Exception {
    HttpResponse<String> answer = ask("GET", at("broken"));
    assertEquals(500, answer.statusCode());
    assertFalse(answer.body().contains("secret"), answer.body());
  }

  @ParameterizedTest
  @ValueSource(strings = {"POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "NEW"})
  void anythingButLooking_isRefused(String method) throws Exception {
    HttpResponse<String> answer = ask(method, at("state"));
    assertEquals(405, answer.statusCode());
    assertEquals("GET, HEAD", answer.headers().firstValue("Allow").orElse(""));
  }

  @Test
  void unknownPath_isNotFound() throws Exception {
    assertEquals(404, ask("GET", at("journal.txt")).statusCode());
    assertTrue(ask("GET", at("state/..%2f..%2fetc")).statusCode() >= 400);
    assertThrows(IOException.class, () -> open("127.0.0.1", port()), "taken");
  }

  @ParameterizedTest
  @ValueSource(strings = {"/", "/state?a="})
  void longAddress_isRefused(String path) throws Exception {
    int status =
        ask("GET", "http://localhost:" + port() + path + "x".repeat(1_000_000)).statusCode();
    assertTrue(status == 414 || status == 431, () -> "status " + status);
    checkAnswers();
  }

  /** A site elsewhere whose name was made to mean this computer. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "Host: evil.example",
        "Host: localhost.evil.example",
        "Host: ",
        "Host: 127.0.0.1.x:80",
        "X: y"
      })
  void foreignHostName_isRefused(String host) throws Exception {
    String answer = answer("GET /state" + query() + " HTTP/1.1\r\n" + host + "\r\n\r\n");
    assertTrue(answer.matches("(?s)HTTP/1.1 40[03].*"), answer);
    assertFalse(answer.contains("\"a\""), answer);
  }

  @ParameterizedTest
  @ValueSource(strings = {"localhost", "127.0.0.1:80", "[::1]:8080"})
  void ownName_isAnswered(String host) throws Exception {
    String answer = answer("GET /state" + query() + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
    assertTrue(answer.startsWith("HTTP/1.1 200"), answer);
  }

  @Test
  void pageOfAnotherSite_isRefused() throws Exception {
    String from = "GET /state" + query() + " HTTP/1.1\r\nHost: localhost:80\r\nOrigin: ";
    assertTrue(answer(from + "http://evil.example\r\n\r\n").startsWith("HTTP/1.1 403"));
    assertTrue(answer(from + "null\r\n\r\n").startsWith("HTTP/1.1 403"));
    assertTrue(answer(from + "http://localhost:80\r\n\r\n").startsWith("HTTP/1.1 200"));
  }

  @Test
  void otherAddress_asksForTheToken() throws Exception {
    try (WebServer page = open("0.0.0.0", 0);
        WebServer other = open("0.0.0.0", 0)) {
      URI uri = URI.create(page.url());
      String plain = "http://127.0.0.1:" + uri.getPort() + "/state";
      assertEquals(403, ask("GET", plain).statusCode());
      assertEquals(403, ask("GET", plain + "?token=").statusCode());
      assertEquals(200, ask("GET", plain + "?" + uri.getQuery()).statusCode());
      assertTrue(uri.getQuery().matches("token=[0-9a-f]{32}"));
      assertFalse(other.url().endsWith(uri.getQuery()));
    }
  }

  @Test
  void everyAnswer_bringsThePolicy() throws Exception {
    for (String path : List.of("", "state", "none", "broken")) {
      HttpResponse<String> answer = ask("GET", at(path));
      String policy = answer.headers().firstValue("Content-Security-Policy").orElse("");
      assertTrue(policy.startsWith("default-src 'none'; "), path + ": " + policy);
      assertTrue(policy.endsWith("; style-src 'self'; script-src 'self'"), policy);
      assertEquals("no-store", answer.headers().firstValue("Cache-Control").orElse(""));
      assertTrue(answer.headers().firstValue("Server").isEmpty());
    }
  }
}
