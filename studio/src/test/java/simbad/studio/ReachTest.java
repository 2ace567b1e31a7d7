package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.SensorKind;
import simbad.gui.Simbatch;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sonar.format.DataFormatException;
import simbad.studio.folders.Folders;
import simbad.studio.folders.Samples;
import simbad.studio.web.Content;
import simbad.studio.web.Guard;
import simbad.studio.web.WebServer;

/**
 * What the page costs. It prints figures and asserts no times; processor time is that of this
 * process, which serves, and of the browser with all its processes, which draws without a graphics
 * card.
 */
@Tag("full")
@Timeout(300)
class ReachTest {
  private static final double SECONDS = 8;
  private static final int LONG = 60_000;

  /** A page that plays asks so often: for what it shows next. */
  private static final int ASKED_EVERY_STEPS = 20_000;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private final Choices choices =
      new Choices(List.of(SensorKind.SHADOW, SensorKind.LEVEL), List.of());

  @BeforeEach
  void browserIsThere() {
    assumeTrue(Visitor.isThere(), "Chromium is not installed");
  }

  private Studio studio(Optional<Folders> folders) throws Exception {
    return Studio.open(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), choices, folders);
  }

  private static double browserS() {
    return ProcessHandle.current()
        .descendants()
        .mapToDouble(
            process ->
                process.info().totalCpuDuration().map(Duration::toMillis).orElse(0L) / 1000.0)
        .sum();
  }

  private static double ownS() {
    return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
            .getProcessCpuTime()
        / 1e9;
  }

  private static double threadS() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1e9;
  }

  private static void say(String text, Object... values) {
    System.out.printf(Locale.ROOT, "reach: " + text + "%n", values);
  }

  @Test
  void tenRobotsWithTwelveSonars() throws Exception {
    try (Studio studio = studio(Optional.empty());
        Visitor visitor = Visitor.at(studio.url(), folder)) {
      visitor.resize(1280, 900, false);
      visitor.await("document.getElementById('rows').children.length === 12");
      visitor.look(
          "{ window.pictures = []; const c = CanvasRenderingContext2D.prototype, draw = c.drawImage;"
              + " c.drawImage = function(...all) { pictures.push(performance.now()); return draw.apply(this, all); };"
              + " const s = document.getElementById('robots'); s.value = '10'; s.dispatchEvent(new Event('change')); }");
      visitor.await("document.getElementById('name0').textContent.includes('of 120 hear')");
      Thread.sleep(2000);
      visitor.look("pictures.length = 0");
      double browser = browserS();
      double own = ownS();
      long begin = System.nanoTime();
      Thread.sleep((long) (1000 * SECONDS));
      double s = (System.nanoTime() - begin) / 1e9;
      String pictures =
          visitor.look(
              "((pictures.length - 1) / (pictures.at(-1) - pictures[0]) * 1000).toFixed(1) + ' pictures/s, '"
                  + " + Math.max(...pictures.slice(1).map((at, i) => at - pictures[i])).toFixed(0) + ' ms between two at most'");
      say(
          "10 robots with 12 sonars: %s; processor %.2f (browser) and %.3f (server) of a core",
          pictures, (browserS() - browser) / s, (ownS() - own) / s);
      assertFalse(pictures.startsWith("NaN"), pictures);
    }
  }

  @Test
  void traceOfAMillionPoints() throws Exception {
    Path shown = folder.resolve("shown");
    Samples.write(shown);
    try (BufferedWriter rows = Files.newBufferedWriter(shown.resolve("runs/one/post/trace.csv"))) {
      rows.write("sensor,step,t_s,x_m,z_m,heading_deg,heard,on_edge\n");
      for (int i = 0; i < 1_000_000; i++) {
        double bearing = Math.PI * i / 12_500;
        double radius = 1.5 + 0.5 * Math.sin(5 * bearing + 1e-5 * i) + 0.01 * Math.sin(i / 40.0);
        rows.write(
            String.format(
                Locale.ROOT,
                "shadow,%d,%.2f,%.6f,%.6f,0.000,1,1\n",
                i + 1,
                0.05 * i,
                radius * Math.sin(bearing),
                radius * Math.cos(bearing)));
      }
    }
    try (Studio studio = studio(Optional.of(Folders.of(shown, List.of())));
        Visitor visitor = Visitor.at(studio.url(), Files.createDirectory(folder.resolve("b")))) {
      visitor.resize(1280, 900, false);
      visitor.await("document.querySelectorAll('#folders tbody tr').length > 5");
      double own = ownS();
      String opened =
          visitor.look(
              """
              (async () => { const begin = performance.now(); location.hash = 'open=runs%2Fone';
                while (!document.querySelector('.readout td')) await new Promise(requestAnimationFrame);
                await new Promise(requestAnimationFrame); return performance.now() - begin; })()""");
      say(
          "1,000,000 points: opened in %.0f ms; %.2f s of processor time (server)",
          Double.parseDouble(opened), ownS() - own);
      String zoomed =
          visitor.look(
              """
              (async () => { const c = document.querySelector('.sheet'), times = []; c.focus();
                for (let i = 0, last = performance.now(); i < 60; i++) {
                  c.dispatchEvent(new KeyboardEvent('keydown', { key: i < 30 ? '+' : '-' }));
                  await new Promise(requestAnimationFrame);
                  const now = performance.now(); times.push(now - last); last = now; }
                times.sort((a, b) => a - b); return times[30].toFixed(1) + ' ms (median), ' + times[59].toFixed(1) + ' ms at most'; })()""");
      say("1,000,000 points: from picture to picture while somebody zooms %s", zoomed);
      assertEquals("", visitor.look("document.getElementById('fault').textContent"));
    }
  }

  @Test
  void firstPaint() throws Exception {
    try (Studio studio = studio(Optional.empty());
        Visitor visitor = Visitor.at(studio.url(), folder)) {
      visitor.await("document.getElementById('clock').textContent.includes('step')");
      for (String which : List.of("first time", "again")) {
        visitor.await("performance.getEntriesByName('first-contentful-paint').length === 1");
        say(
            "first paint %s: %s ms, all files there after %s ms",
            which,
            visitor.look(
                "performance.getEntriesByName('first-contentful-paint')[0].startTime.toFixed(0)"),
            visitor.look(
                "Math.max(...performance.getEntriesByType('resource').filter(r => r.name.includes('.js')).map(r => r.responseEnd)).toFixed(0)"));
        visitor.look("location.reload()");
        Thread.sleep(2000);
      }
    }
  }

  /** The world as it is stepped by nobody who looks, and by the page that plays 5000 times. */
  @Test
  void worldThatIsFollowed() throws Exception {
    StudioScene scene =
        new StudioScene("angle", "shadow", "srf04", "", 1, Optional.empty(), 0.01, 1, List.of());
    double alone = Double.POSITIVE_INFINITY;
    double followed = Double.POSITIVE_INFINITY;
    double whole = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 5; i++) {
      alone = Math.min(alone, seconds());
      followed = Math.min(followed, seconds(world(scene), 20));
      whole = Math.min(whole, seconds(world(scene), 1));
    }
    double added = (followed - alone) / LONG;
    say(
        "a step takes %.2f us alone, %.2f us followed (every 20th step shown), %.2f us with every step shown",
        1e6 * alone / LONG, 1e6 * followed / LONG, 1e6 * whole / LONG);
    say("following slows a simulation of 100,000 steps/s by %.1f %%", 100 * added * 100_000);
    assertTrue(followed > 0);
  }

  /** The frames of a world that plays 5000 times: asked for, or told as server-sent events. */
  @Test
  void framesThatAreAskedFor_andFramesThatAreTold() throws Exception {
    double asked = Double.POSITIVE_INFINITY;
    double told = Double.POSITIVE_INFINITY;
    for (int seed = 1; seed <= 5; seed++) {
      int world = seed;
      Worlds forQuestions = new Worlds(choices);
      Worlds forEvents = new Worlds(choices);
      AtomicInteger next = new AtomicInteger();
      Map<String, Function<String, Content>> questions =
          Map.of("/frames", question -> Content.json(frames(forQuestions, question)));
      Map<String, Function<String, String>> streams =
          Map.of(
              "/told", of -> frames(forEvents, frames(world, next.getAndAdd(ASKED_EVERY_STEPS))));
      InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
      Guard guard = Guard.of(address.getAddress());
      try (WebServer server =
          WebServer.open(address, guard, new WebServer.Answers(Map.of(), questions, streams))) {
        asked = Math.min(asked, asked(server, world));
        told = Math.min(told, told(server));
      }
    }
    say(
        "frames of %d steps: %.0f ms of processor time asked for, %.0f ms told (both ends)",
        LONG, 1e3 * asked, 1e3 * told);
    assertTrue(asked > 0);
  }

  private static String frames(int seed, int from) {
    return """
        {"scene": {"format": "simbad-studio/1", "obstacle": "angle", "sensor": "shadow", "robots": 1,
          "speed_m_per_s": 0.01, "seed": %d, "moves": []}, "from": %d, "count": %d, "every": 20}"""
        .formatted(seed, Math.min(from, LONG - ASKED_EVERY_STEPS), ASKED_EVERY_STEPS / 20);
  }

  private static String frames(Worlds worlds, String question) {
    try {
      return worlds.frames(question);
    } catch (DataFormatException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private static HttpRequest.Builder request(WebServer server, String path) {
    return HttpRequest.newBuilder(URI.create(server.url().replace("/?", path + "?")));
  }

  private static double asked(WebServer server, int seed) throws Exception {
    HttpClient client = HttpClient.newHttpClient();
    double begin = ownS();
    for (int from = 0; from < LONG; from += ASKED_EVERY_STEPS) {
      HttpRequest.Builder request =
          request(server, "/frames").POST(BodyPublishers.ofString(frames(seed, from)));
      assertEquals(200, client.send(request.build(), BodyHandlers.ofString()).statusCode());
    }
    return ownS() - begin;
  }

  private static double told(WebServer server) throws Exception {
    HttpClient client = HttpClient.newHttpClient();
    double begin = ownS();
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                client.send(request(server, "/told").build(), BodyHandlers.ofInputStream()).body(),
                StandardCharsets.UTF_8))) {
      for (int left = LONG / ASKED_EVERY_STEPS; left > 0; ) {
        left -= lines.readLine().startsWith("data: {") ? 1 : 0;
      }
    }
    return ownS() - begin;
  }

  private static LiveWorld world(StudioScene scene) {
    return new LiveWorld(
        scene,
        Catalogue.find("angle").orElseThrow(),
        SensorKind.SHADOW,
        SensorKind.SHADOW,
        Catalogue.srf04());
  }

  /** The same world, of which nobody notes anything. */
  private static double seconds() {
    ObstacleType type = Catalogue.find("angle").orElseThrow();
    Circuit circuit =
        new Circuit(
            type, List.of(), SensorKind.SHADOW, Catalogue.srf04(), 0.01, Optional.empty(), 1);
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.add(new SonarObstacle(new Vector3d(), 0, type));
    environment.add(circuit.robot(new EdgeFollower(Tuning.standard(0.01, Circuit.STEP_S))));
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    double begin = threadS();
    for (int i = 0; i < LONG; i++) {
      simulation.step();
    }
    double taken = threadS() - begin;
    simulation.dispose();
    return taken;
  }

  private static double seconds(LiveWorld world, int every) {
    double begin = threadS();
    int most = Math.min(LiveWorld.MOST_FRAMES, ASKED_EVERY_STEPS / every);
    for (int from = 0; from < LONG; from += most * every) {
      assertTrue(world.frames(from, most, every).length() > 2);
    }
    double taken = threadS() - begin;
    world.dispose();
    return taken;
  }
}
