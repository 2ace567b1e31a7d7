package simbad.studio.folders;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.run.SensorKind;
import simbad.studio.Choices;
import simbad.studio.Studio;

/** What others than the page get of a folder: nothing without the token, nothing outside it. */
class FoldersOverHttpTest {
  private static final HttpClient CLIENT = HttpClient.newHttpClient();
  private static final String SECRET = "a secret that is nobody's";
  private static final int HANGING = 200;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Studio studio;

  @BeforeAll
  static void open() throws Exception {
    Samples.write(folder.resolve("shown"));
    Files.writeString(folder.resolve("secret.csv"), SECRET);
    studio =
        Studio.open(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            new Choices(List.of(SensorKind.SHADOW), List.of()),
            Optional.of(Folders.of(folder.resolve("shown"), List.of())));
  }

  @AfterAll
  static void close() {
    studio.close();
  }

  private static String token() {
    return "?" + URI.create(studio.url()).getQuery();
  }

  private static int port() {
    return URI.create(studio.url()).getPort();
  }

  private static HttpResponse<String> post(String path, String body, String... headers)
      throws Exception {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(URI.create("http://localhost:" + port() + path))
            .POST(BodyPublishers.ofString(body));
    if (headers.length > 0) {
      request.headers(headers);
    }
    return CLIENT.send(request.build(), BodyHandlers.ofString());
  }

  @Test
  void onlyWhoHasTheTokenIsAnswered() throws Exception {
    String question = "{\"path\": \"batch\"}";
    assertTrue(post("/folder" + token(), question).body().contains("mean_abs_cm"));
    assertEquals(403, post("/folder", question).statusCode());
    assertEquals(403, post("/folder?token=0", question).statusCode());
    assertEquals(
        403, post("/folder" + token(), question, "Origin", "http://evil.example").statusCode());
  }

  /** Every path by every method, with no token and each that is nearly one, is forbidden. */
  @Test
  void noPathLetsInWithoutTheToken() throws Exception {
    String right = token().substring("?token=".length());
    List<String> queries =
        List.of(
            "",
            "?",
            "?token=",
            "?token=" + right.substring(1),
            "?token=" + right + "0",
            "?TOKEN=" + right,
            "?token=" + right + "&token=" + right,
            "?x=1&token=" + right,
            "?token=" + right + "&path=a&path=b",
            "?path=captures/post",
            "?path=a&token=" + right,
            "#?token=" + right);
    for (String path :
        List.of(
            "/",
            "/views",
            "/catalogue",
            "/folders",
            "/folder",
            "/frames",
            "/loudness",
            "/watch",
            "/trace",
            "/state.js",
            "/uPlot.min.css",
            "/none",
            "/..;/folder",
            "//folders")) {
      for (String query : queries) {
        for (String method : List.of("GET", "HEAD", "POST", "PUT", "OPTIONS")) {
          checkRefused(method, path + query, "Host: localhost");
        }
      }
    }
  }

  /** The token alone does not do: who asks must ask this computer, and not from another's page. */
  @Test
  void noHostAndNoOriginLetsIn() throws Exception {
    for (String path : List.of("/", "/folders", "/state.js")) {
      for (String host :
          List.of(
              "evil.example",
              "localhost.evil.example",
              "localhost@evil.example",
              "127.0.0.1.evil.example",
              "10.0.0.1",
              "[::2]")) {
        checkRefused("GET", path + token(), "Host: " + host + ":" + port());
      }
      for (String origin :
          List.of(
              "null",
              "http://evil.example",
              "https://localhost:" + port(),
              "http://localhost:" + (port() + 1),
              "http://localhost",
              "http://localhost:" + port() + ".evil.example")) {
        checkRefused("GET", path + token(), "Host: localhost:" + port() + "\r\nOrigin: " + origin);
      }
      checkRefused("GET", path + token(), "X-Forwarded-Host: localhost");
    }
    String own = "Host: localhost:" + port() + "\r\nOrigin: http://localhost:" + port();
    assertTrue(
        raw("GET /folders" + token() + " HTTP/1.1\r\n" + own + "\r\n\r\n").contains(" 200 "));
  }

  private static void checkRefused(String method, String address, String headers) throws Exception {
    String answer =
        raw(method + " " + address + " HTTP/1.1\r\n" + headers + "\r\nContent-Length: 0\r\n\r\n");
    assertTrue(
        answer.matches("(?s)HTTP/1.1 40[0-9] .*"), () -> method + address + headers + answer);
    assertFalse(answer.contains("<canvas") || answer.contains("shown"), answer);
  }

  /** As it goes over the line: a client of its own would tidy the path up. */
  @Test
  void noPathLeadsOut() throws Exception {
    for (String path :
        List.of("/../secret.csv", "/folder/../../secret.csv", "/..%2fsecret.csv", "/secret.csv")) {
      String answer = raw("GET " + path + token() + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
      assertTrue(answer.matches("(?s)HTTP/1.1 40[0-9].*"), answer);
      assertFalse(answer.contains(SECRET), answer);
    }
    for (String path : List.of("..", "../secret.csv", "/", folder.toString(), "runs/../..")) {
      String answer = post("/folder" + token(), "{\"path\": \"" + path + "\"}").body();
      assertTrue(answer.startsWith("{\"fault\":"), answer);
      assertFalse(answer.contains("secret that"), answer);
    }
  }

  private static String raw(String request) throws Exception {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port())) {
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void garbageIsAnsweredWithItsFault() throws Exception {
    for (String body : List.of("", "\u0000", "[[[[", "{\"path\": 7}", "{\"path\": \"x\"} more")) {
      for (String path : List.of("/folder", "/trace", "/loudness", "/frames")) {
        HttpResponse<String> answer = post(path + token(), body);
        assertEquals(200, answer.statusCode(), body);
        assertTrue(answer.body().startsWith("{\"fault\":"), answer.body());
      }
    }
    assertEquals(413, post("/folder" + token(), "x".repeat(100_000)).statusCode());
  }

  /** Half a question each. */
  @Test
  void whoHangsKeepsNobodyOut() throws Exception {
    List<Socket> hanging = new ArrayList<>();
    try {
      for (int i = 0; i < HANGING; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port());
        hanging.add(socket);
        String half =
            "POST /folder"
                + token()
                + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 50\r\n\r\n{";
        socket.getOutputStream().write(half.getBytes(StandardCharsets.UTF_8));
      }
      assertTrue(post("/folder" + token(), "{\"path\": \"batch\"}").body().contains("columns"));
    } finally {
      for (Socket socket : hanging) {
        socket.close();
      }
    }
  }
}
