package simbad.studio.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.capture.Approach;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.SweepState;
import simbad.bench.capture.TriedDistance;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.studio.Studio;
import simbad.studio.Visitor;

/** The studio at a capture in headless Chromium, served as in a capture. */
@Timeout(180)
class WatchInBrowserTest {
  private static final String PLOT =
      "JSON.stringify(document.getElementById('plot').getBoundingClientRect())";
  private static final String SHOWN = "document.getElementById('reading').textContent";

  /** What sticks out of its box, and whether the page is wider than the window. */
  private static final String CUT =
      """
      [...document.querySelectorAll('#watch div, #watch h2')].filter(e => e.scrollWidth > e.clientWidth)
        .map(e => e.id + ' ' + e.textContent).join('; ')
        + (document.documentElement.scrollWidth > innerWidth ? ' wide' : '')""";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private final SweepPlan plan = SweepPlan.ofBearings(72);
  private final SweepState sweep = new SweepState();
  private final LiveState live =
      new LiveState("angle-25mm", plan, new Ranging(20, FirmwareMode.FRAME));
  private int pings;

  private void take(PingStatus status, double distanceM) {
    int echoUs = (int) Math.round(distanceM * 5828);
    OptionalInt echo = status == PingStatus.ECHO ? OptionalInt.of(echoUs) : OptionalInt.empty();
    TriedDistance probe = new TriedDistance(distanceM, Approach.OUT);
    Entry.Taken taken =
        new Entry.Taken(pings++, 0, probe, pings, status, echo, OptionalDouble.empty());
    sweep.take(taken);
    live.take(taken, sweep);
    live.read(new FrameLine.Ping(pings, status, echo, 70));
  }

  private Visitor watcher(Studio page) throws Exception {
    assumeTrue(Visitor.isThere(), "no Chromium on this machine: the page is not looked at");
    return Visitor.at(page.url(), folder);
  }

  private Studio open(LiveState live) throws Exception {
    return Studio.ofCapture(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), folder.resolve("later"), live);
  }

  @ParameterizedTest
  @CsvSource({"1280, 800", "390, 844", "1920, 1080", "844, 390", "2560, 1440"})
  void lostEcho_movesNothing_andIsNotCutOff(int width, int height) throws Exception {
    try (Studio page = open(live);
        Visitor watcher = watcher(page)) {
      watcher.resize(width, height, width < 900);
      List<String> places = new ArrayList<>();
      for (PingStatus status : PingStatus.values()) {
        for (int i = 0; i < plan.pings(); i++) {
          take(status, 2.95);
        }
        String shown = status == PingStatus.ECHO ? "295.0" : status.word();
        watcher.await(SHOWN + " === '" + shown + "'");
        assertEquals("", watcher.look(CUT), status.word());
        places.add(watcher.look(PLOT));
      }
      assertEquals("[]", watcher.violations());
      assertEquals(1, places.stream().distinct().count(), () -> String.join("\n", places));
    }
  }

  /** It opens at the capture; the live world and the capture's folder are on the same page. */
  @Test
  void captureIsAViewOfTheStudio_withItsPictureToSave() throws Exception {
    take(PingStatus.ECHO, 1);
    try (Studio page = open(live);
        Visitor watcher = watcher(page)) {
      watcher.await(SHOWN + " === '100.0'");
      watcher.look(
          "window.saved = []; const make = URL.createObjectURL; URL.createObjectURL = blob => { blob.text().then(text => saved.push(text)); return make(blob); }");
      watcher.click("#watchsvg");
      watcher.await(
          "saved.length === 1 && saved[0].includes('<circle') && saved[0].includes('stroke')");
      watcher.click("#watchcsv");
      watcher.await("saved.length === 2 && saved[1].startsWith('bearing_deg,threshold_m')");
      watcher.click("#to-live");
      watcher.await("document.getElementById('rows').children.length === 12");
      watcher.click("#to-folders");
      watcher.await("document.getElementById('fault').textContent.includes('no such folder')");
      watcher.click("#to-watch");
      watcher.await(
          "document.getElementById('state').textContent.length > 0 && !document.getElementById('watch').hidden");
      assertEquals("", watcher.look("document.getElementById('fault').textContent"));
    }
  }

  /** Nobody follows a server that is gone for nothing: the page says so, and in time. */
  @Test
  void endOfTheCapture_isSaid() throws Exception {
    Studio page = open(live);
    take(PingStatus.ECHO, 1);
    try (Visitor watcher = watcher(page)) {
      watcher.await(SHOWN + " === '100.0'");
      page.close();
      watcher.await("document.getElementById('state').textContent.startsWith('NOT LIVE')");
    } finally {
      page.close();
    }
  }
}
