package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
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
import java.nio.file.Files;
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
import simbad.motion.MotionChange;
import simbad.sonar.format.DataFormatException;

/** The page as its readers and others meet it: over HTTP, and with mouse and keyboard. */
class StudioTest {
  private static final HttpClient CLIENT = HttpClient.newHttpClient();
  private static final int HANGING = 200;
  private static final int FAR = 3000;

  /** Half as fast as it is told. */
  private static final MotionChain HALF =
      MotionChain.EXACT.with(
          new MotionChange() {
            @Override
            public double speed(double speedMPerS, double turnRadPerS) {
              return speedMPerS / 2;
            }
          });

  @SuppressWarnings("NullAway.Init")
  private static Studio studio;

  @BeforeAll
  static void open() throws Exception {
    studio =
        Studio.open(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            new Choices(
                List.of(SensorKind.SHADOW, SensorKind.ORIGINAL, SensorKind.LEVEL),
                List.of(new RobotKind("slow", HALF)),
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
      "Promise.all(['kit', 'state', 'plan', 'scene-files', 'hands'].map(n => import('/' + n + '.js' + location.search)))"
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
      // Keys that come faster than answers: no press is lost, and none goes back in time.
      String pressed =
          "(() => { const x = frameOf(worlds[0])[0], step = stepOf(worlds[0]); for (const key of ['ArrowRight', '[', 'ArrowRight', 'ArrowRight'])"
              + " $('plan0').dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));"
              + " return [Math.round(100 * (frameOf(worlds[0])[0] - x)), stepOf(worlds[0]) - step, live.scene.moves.length].join(); })()";
      assertEquals("15,0,2", visitor.look(pressed));
      visitor.await("worlds[0].frames.length > 6 && frameOf(worlds[0]) === worlds[0].frames[6]");
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

  /** Where something of a world is in the window, in pixels. */
  private static double[] at(Visitor visitor, String xz) throws Exception {
    String place =
        "(() => { const f = frameOf(worlds[0]), v = view($('plan0'), f), b = $('plan0').getBoundingClientRect(), p = "
            + xz
            + "; return [b.x + v.x(p[0]), b.y + v.y(p[1])].join(); })()";
    String[] numbers = visitor.look(place).split(",", -1);
    return new double[] {Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1])};
  }

  @Test
  void aVisitorLetsSeveralRobotsDrive_zoomsAndLooksAtOne(@TempDir Path folder) throws Exception {
    assumeTrue(Visitor.isThere(), "Chromium is not installed");
    try (Visitor visitor = Visitor.at(studio.url(), folder)) {
      visitor.resize(1280, 900, false);
      visitor.await("document.getElementById('rows').children.length === 12");
      visitor.look(MODULES);
      visitor.look("$('robots').value = '3'; $('robots').dispatchEvent(new Event('change'))");
      visitor.await("$('name0').textContent.includes('of 36 hear') && !$('whichrow').hidden");
      visitor.look("setPlaying(false); go(4)");
      visitor.await("Math.floor(live.now) === 4 && worlds[0].frames[4] !== undefined");
      // The second robot is dragged: it is the one that the table then shows.
      double[] second = at(visitor, "(r => [r.x, r.z])(robotsOf(f)[1])");
      visitor.drag(second[0], second[1], 50, -30);
      visitor.await(
          "live.scene.moves.length === 1 && live.scene.moves[0].number === 1 && $('which').value === '1'");
      visitor.await("$('linenote').textContent.includes('--scene scene.json shows all of it')");
      // By keys: nearer, and back; the obstacle where it was pulled to.
      visitor.look("$('plan0').focus()");
      String scale = "view($('plan0'), frameOf(worlds[0])).scale";
      double far = Double.parseDouble(visitor.look(scale));
      visitor.press("+", 187);
      visitor.await(scale + " > 1.2 * " + far);
      double[] beside = at(visitor, "[2, 2]");
      visitor.drag(beside[0], beside[1], -40, -40);
      visitor.await("live.off[0] > 0.05 && live.off[1] > 0.05 && live.scene.moves.length === 1");
      visitor.press("0", 48);
      visitor.await("live.off[0] === 0 && live.zoom === 1");
      visitor.click("#closer");
      visitor.await("live.zoom === 1.5");
      // As fast as it goes, and each step is there when somebody looks.
      visitor.look("$('speed').value = '5000'");
      visitor.click("#play");
      visitor.await("worlds[0].upTo > endStep() && Math.floor(live.now) === endStep()");
      visitor.await("worlds[0].known.length < worlds[0].upTo / 5");
      visitor.look("go(1234)");
      visitor.await("worlds[0].frames[1234] !== undefined && stepOf(worlds[0]) === 1234");
      // What is saved has every step of every robot, of both sensors.
      visitor.look(
          "$('sensor1').value = 'original'; $('sensor1').dispatchEvent(new Event('change')); go(0)");
      visitor.await("worlds[1].upTo > 20 && worlds[0].upTo > 20");
      visitor.look("go(20)");
      visitor.await("Math.floor(live.now) === 20");
      visitor.await("csv().then(text => text.split('\\n').length === 2 + 2 * 3 * 21)");
      visitor.await("$('heads').textContent === 'Looksshadoworiginal'");
      visitor.look("opened(saved())");
      visitor.await("live.scene.robots === 3 && live.beside === 'original' && worlds[0].upTo > 20");
      visitor.await("$('fault').textContent === ''");
      assertEquals("[]", visitor.violations());
    }
  }

  /** The same sensor on a robot that does what it is told, and on one that is slower. */
  @Test
  void motionAsToldBesideMotionAsDiagnosed(@TempDir Path folder) throws Exception {
    assumeTrue(Visitor.isThere(), "Chromium is not installed");
    try (Visitor visitor = Visitor.at(studio.url(), folder)) {
      visitor.await("document.getElementById('rows').children.length === 12");
      visitor.look(MODULES);
      visitor.await("$('robot1row').hidden");
      visitor.look(
          "$('sensor1').value = 'shadow'; $('sensor1').dispatchEvent(new Event('change'))");
      visitor.await("!$('robot1row').hidden && worlds[1].upTo > 100");
      visitor.look(
          "$('robot1').value = 'slow'; $('robot1').dispatchEvent(new Event('change')); go(100)");
      visitor.await("worlds[0].upTo > 100 && worlds[1].upTo > 100 && Math.floor(live.now) === 100");
      visitor.await("$('name1').textContent.startsWith('shadow, moves as slow')");
      visitor.await("$('name0').textContent.startsWith('shadow \u00b7')");
      // Half as fast: half as far.
      String way =
          "(w => Math.hypot(w.frames[100][0] - w.frames[0][0], w.frames[100][1] - w.frames[0][1]))";
      visitor.await(way + "(worlds[1]) < 0.6 * " + way + "(worlds[0])");
      visitor.await(
          "$('line').textContent.includes('./simbad run angle --sensor shadow --robot diagnosed:lame ')");
      visitor.look("opened(saved())");
      visitor.await(
          "live.besideRobot === 'slow' && $('robot1').value === 'slow' && worlds[1].upTo > 20");
      visitor.await("$('fault').textContent === ''");
      assertEquals("[]", visitor.violations());
    }
  }

  /** It opens where it was saved; what is not a scene of these choices is refused by name. */
  @Test
  void aSavedSceneIsOpenedAtTheStart(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("scene.json");
    Files.writeString(
        file,
        """
        {"format": "simbad-studio/1", "obstacle": "round", "sensor": "original", "sonar": "srf04", "robot": "", "robots": 2,
         "speed_m_per_s": 0.02, "seed": 5, "moves": [{"step": 0, "obstacle": [0.3, 0], "turn_deg": 45}], "beside": "shadow"}
        """);
    Choices choices = new Choices(List.of(SensorKind.SHADOW, SensorKind.ORIGINAL), List.of());
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try (Studio saved = Studio.open(address, choices, Optional.empty(), Optional.of(file))) {
      assumeTrue(Visitor.isThere(), "Chromium is not installed");
      try (Visitor visitor = Visitor.at(saved.url(), folder)) {
        visitor.await("document.getElementById('name0').textContent.startsWith('original')");
        visitor.look(MODULES);
        visitor.await(
            "live.scene.seed === 5 && live.beside === 'shadow' && $('robots').value === '2' && worlds[0].upTo > 5");
        visitor.await("frameOf(worlds[0])[3] === 0.3");
      }
    }
    Files.writeString(file, Files.readString(file).replace("round", "nothing"));
    String refusal =
        String.valueOf(
            assertThrows(
                    DataFormatException.class,
                    () -> Studio.open(address, choices, Optional.empty(), Optional.of(file)))
                .getMessage());
    assertTrue(refusal.contains("scene.json") && refusal.contains("obstacle"), refusal);
  }
}
