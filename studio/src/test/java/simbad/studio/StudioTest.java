package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.OutputStream;
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
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.motion.MotionChain;

/** The page as its readers and others meet it: over HTTP, and with mouse and keyboard. */
class StudioTest {
  private static final HttpClient CLIENT = HttpClient.newHttpClient();
  private static final int HANGING = 200;
  private static final int FAR = 3000;

  @SuppressWarnings("NullAway.Init")
  private static Studio studio;

  @BeforeAll
  static void open() throws Exception {
    studio =
        Studio.open(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            new Choices(
                List.of(SensorKind.SHADOW, SensorKind.ORIGINAL, SensorKind.LEVEL),
                List.of(new RobotKind("slow", MotionChain.EXACT)),
                Map.of("slow", "diagnosed:lame")),
            Optional.empty());
  }

  @AfterAll
  static void close() {
    studio.close();
  }

  private static URI at(String path, String query) {
    URI page = URI.create(studio.url());
    return URI.create("http://localhost:" + page.getPort() + path + query);
  }

  private static String token() {
    return "?" + URI.create(studio.url()).getQuery();
  }

  private static HttpResponse<String> get(URI address, String... headers) throws Exception {
    HttpRequest.Builder request = HttpRequest.newBuilder(address);
    if (headers.length > 0) {
      request.headers(headers);
    }
    return CLIENT.send(request.build(), BodyHandlers.ofString());
  }

  @Test
  void withoutItsTokenNothingIsAnswered() throws Exception {
    assertEquals(200, get(at("/", token())).statusCode());
    assertEquals(403, get(at("/", "")).statusCode());
    assertEquals(403, get(at("/catalogue", "?token=0123")).statusCode());
    assertEquals(403, get(at("/", token()), "Origin", "http://evil.example").statusCode());
    assertEquals(404, get(at("/pom.xml", token())).statusCode());
    assertEquals(200, get(at("/state.js", token())).statusCode());
    assertEquals(403, get(at("/state.js", "")).statusCode());
    assertEquals(404, get(at("/folder", token())).statusCode());
  }

  @Test
  void itsPolicyLetsNothingInFromElsewhere() throws Exception {
    String policy =
        get(at("/", token())).headers().firstValue("Content-Security-Policy").orElse("");

    assertTrue(policy.contains("default-src 'none'"), policy);
    assertTrue(policy.endsWith("script-src 'self'"), policy);
  }

  @Test
  void aBadQuestionIsAnsweredWithItsFault() throws Exception {
    HttpRequest request =
        HttpRequest.newBuilder(at("/frames", token()))
            .POST(BodyPublishers.ofString("{\"scene\": 7}"))
            .build();
    HttpResponse<String> answer = CLIENT.send(request, BodyHandlers.ofString());

    assertTrue(answer.body().contains("\"fault\""), answer.body());
  }

  /** A page elsewhere whose name was made to point here has another Host. */
  @Test
  void anotherHostsNameIsRefused() throws Exception {
    int port = URI.create(studio.url()).getPort();
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      String request =
          "GET /"
              + token()
              + " HTTP/1.1\r\nHost: evil.example:"
              + port
              + "\r\nConnection: close\r\n\r\n";
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertTrue(answer.startsWith("HTTP/1.1 403"), answer);
    }
  }

  /**
   * Questions that are too long, or nested without end, or no text: each is refused, none hurts.
   */
  @Test
  void aFloodOfBadQuestionsIsRefused() throws Exception {
    List<String> bad = List.of("x".repeat(100_000), "[".repeat(60_000), "\u0000", "");
    for (int i = 0; i < HANGING; i++) {
      HttpRequest request =
          HttpRequest.newBuilder(at("/frames", token()))
              .POST(BodyPublishers.ofString(bad.get(i % bad.size())))
              .build();
      HttpResponse<String> answer = CLIENT.send(request, BodyHandlers.ofString());
      boolean tooLong = i % bad.size() == 0;
      assertEquals(tooLong ? 413 : 200, answer.statusCode(), answer.body());
      assertTrue(tooLong || answer.body().contains("\"fault\""), answer.body());
    }
    assertEquals(200, get(at("/", token())).statusCode());
  }

  /** Who sends all of what is too long before reading finds the answer there, not a reset. */
  @Test
  void tooLongQuestion_isAnsweredToWhoSendsItWhole() throws Exception {
    int port = URI.create(studio.url()).getPort();
    for (int i = 0; i < 5; i++) {
      try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
        String head =
            "POST /frames"
                + token()
                + " HTTP/1.1\r\nHost: localhost:"
                + port
                + "\r\nContent-Length: 300000\r\n\r\n";
        OutputStream out = socket.getOutputStream();
        out.write((head + "x".repeat(150_000)).getBytes(StandardCharsets.UTF_8));
        Thread.sleep(100);
        out.write("x".repeat(150_000).getBytes(StandardCharsets.UTF_8));
        Thread.sleep(100);
        String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(answer.startsWith("HTTP/1.1 413"), answer);
      }
    }
  }

  /** Half a request each, and garbage. */
  @Test
  void itGoesOnServingWhileMostHang() throws Exception {
    List<Socket> hanging = new ArrayList<>();
    try {
      for (int i = 0; i < HANGING; i++) {
        Socket socket =
            new Socket(InetAddress.getLoopbackAddress(), URI.create(studio.url()).getPort());
        hanging.add(socket);
        OutputStream out = socket.getOutputStream();
        out.write((i % 2 == 0 ? "GET / HT" : "\u0000\u0001\r\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
      }
      assertEquals(200, get(at("/", token())).statusCode());
    } finally {
      for (Socket socket : hanging) {
        socket.close();
      }
    }
  }

  /** What the page's modules give away, as names that the steps below can use. */
  private static final String MODULES =
      "Promise.all(['kit', 'state', 'plan', 'scene-files'].map(n => import('/' + n + '.js' + location.search)))"
          + ".then(all => { for (const one of all) for (const [k, v] of Object.entries(one)) window[k] = v; })";

  @Test
  void aVisitorPlaysScrubsAndDrags(@TempDir Path folder) throws Exception {
    assumeTrue(Visitor.isThere(), "Chromium is not installed");
    try (Visitor visitor = Visitor.at(studio.url(), folder)) {
      visitor.await(
          "document.getElementById('rows').children.length === 12 && document.getElementById('fault').textContent === ''");
      visitor.look(MODULES);
      visitor.await("worlds[0].frames.length > 50");
      visitor.await("Number(document.getElementById('scrub').value) > 20");
      visitor.click("#play");
      visitor.await("document.getElementById('play').textContent === 'Play'");
      visitor.look(
          "document.getElementById('scrub').value = 5; document.getElementById('scrub').dispatchEvent(new Event('input'))");
      visitor.await("document.getElementById('clock').textContent.includes('step 5')");
      visitor.click("#step");
      visitor.await("document.getElementById('clock').textContent.includes('step 6')");
      // The bar's end stands still, and all that a legend names is there.
      visitor.await("$('scrub').max === String(endStep()) && worlds[0].frames.length < endStep()");
      visitor.look("go(" + FAR + ")");
      visitor.await("$('scrub').value === '" + FAR + "'");
      visitor.await("Math.floor(live.now) === " + FAR + " && $('scrub').max === String(endStep())");
      visitor.look("go(6)");
      visitor.await("!$('ringed').hidden && $('limit').hidden");
      visitor.look("$('near').value = 'obstacle'; $('near').dispatchEvent(new Event('change'))");
      visitor.await("$('ringed').hidden");
      visitor.look("$('near').value = ''; $('near').dispatchEvent(new Event('change'))");
      // The table of the sonars is on a laptop's first screen.
      visitor.resize(1280, 800, false);
      visitor.await("scrollTo(0, 0), $('rows').getBoundingClientRect().bottom <= innerHeight");
      // The picture as SVG is XML, and has all that is drawn.
      visitor.await(
          "(x => !x.querySelector('parsererror') && x.querySelectorAll('path').length > 20)"
              + "(new DOMParser().parseFromString(svgNow(), 'image/svg+xml'))");
      // Markup in a file that is opened stays text.
      visitor.look(
          "try { opened(JSON.stringify({format: FORMAT, moves: [], obstacle: '<img src=x>'})); } catch (e) { fault(e.message); }");
      visitor.await(
          "$('fault').textContent.includes('<img src=x>') && !document.querySelector('img')");
      visitor.look("fault('')");
      // By hand: the robot goes where it is dragged, and the command line says so.
      String place =
          "(() => { const f = frameOf(worlds[0]), v = view($('plan0'), f), b = $('plan0').getBoundingClientRect();"
              + " return JSON.stringify([b.x + v.x(f[0]), b.y + v.y(f[1])]); })()";
      visitor.look("scrollTo(0, 0)");
      String[] at = visitor.look(place).replaceAll("[\\[\\]]", "").split(",", -1);
      visitor.drag(Double.parseDouble(at[0]), Double.parseDouble(at[1]), 60, -20);
      visitor.await("live.scene.moves.length === 1 && live.scene.moves[0].step === 6");
      visitor.await("document.getElementById('linenote').textContent.includes('moves by hand')");
      visitor.look("$('plan0').focus()");
      visitor.press("ArrowLeft", 37);
      visitor.await("live.scene.moves.length === 1 && worlds[0].frames.length > 6");
      visitor.press("[", 219);
      visitor.await("live.scene.moves.some(m => m.turn_deg === 5) && worlds[0].frames.length > 6");
      // Another sonar and another robot: the command line says so.
      visitor.look(
          "$('sonar').value = 'hc-sr04'; $('sonar').dispatchEvent(new Event('change'));"
              + " $('robot').value = 'slow'; $('robot').dispatchEvent(new Event('change'))");
      visitor.await(
          "worlds[0].frames.length > 6 && $('line').textContent.includes('--sensor-file data/sensors/hc-sr04.json --robot diagnosed:lame')");
      // The level law's shadow is loudness, as shade.
      visitor.look("$('sensor0').value = 'level'; $('sensor0').dispatchEvent(new Event('change'))");
      visitor.await("loudness('level').length === 5 && !$('louder').hidden");
      visitor.look(
          "opened(saved().replace('hc-sr04', 'srf04').replace('\"level\"', '\"shadow\"'))");
      visitor.await(
          "$('louder').hidden && live.scene.robot === 'slow' && live.scene.sonar === 'srf04' && worlds[0].frames.length > 6");
      // Two beside each other.
      visitor.look(
          "$('sensor1').value = 'original'; $('sensor1').dispatchEvent(new Event('change'))");
      visitor.await("!document.getElementById('second').hidden && worlds[1].frames.length > 6");
      visitor.await("!$('limit').hidden");
      visitor.await("document.getElementById('fault').textContent === ''");
      for (int width : new int[] {390, 1280, 2560}) {
        visitor.resize(width, 900, width == 1280);
        visitor.await("document.documentElement.scrollWidth <= innerWidth");
        assertEquals("[]", visitor.violations());
        // No reason is broken over two lines.
        visitor.await(
            "[...$('rows').rows].every(r => r.getBoundingClientRect().height < 2.2 * parseFloat(getComputedStyle(r).fontSize))");
      }
    }
  }
}
