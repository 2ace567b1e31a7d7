package simbad.studio.folders;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.run.SensorKind;
import simbad.studio.Choices;
import simbad.studio.Studio;
import simbad.studio.Visitor;

/** A person who looks through a folder: clicks, points, moves sliders, types. */
@Timeout(300)
class FoldersInBrowserTest {
  /** Keeps what is saved where a step can look at it. */
  private static final String KEEP_WHAT_IS_SAVED =
      "window.saved = []; URL.createObjectURL = blob => { blob.text().then(text => saved.push(text)); return '#' + location.hash.slice(1); }; 1";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Studio studio;

  @SuppressWarnings("NullAway.Init")
  private Visitor visitor;

  @BeforeAll
  static void open() throws Exception {
    assumeTrue(Visitor.isThere(), "Chromium is not installed");
    Samples.write(folder.resolve("shown"));
    Folders shown = Folders.of(folder.resolve("shown"), List.of());
    studio =
        Studio.open(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            new Choices(List.of(SensorKind.SHADOW), List.of()).with(shown),
            Optional.of(shown));
  }

  @AfterAll
  static void close() {
    if (studio != null) {
      studio.close();
    }
  }

  @BeforeEach
  void look(@TempDir Path own) throws Exception {
    visitor = Visitor.at(studio.url(), own);
    visitor.resize(1280, 900, false);
    visitor.await("document.querySelectorAll('#folders tbody tr').length === 11");
  }

  @AfterEach
  void leave() {
    visitor.close();
  }

  private void show(String hash, String until) throws Exception {
    visitor.look("location.hash = '" + hash + "'");
    visitor.await(until);
  }

  /** Nothing sticks out at any width, and axe has nothing to say, in either theme. */
  private void checkWholeAndForEverybody(String until) throws Exception {
    for (int width : new int[] {390, 1280, 2560}) {
      visitor.resize(width, 900, width == 390);
      visitor.await(until);
      visitor.await("document.documentElement.scrollWidth <= innerWidth");
    }
    assertEquals("[]", visitor.violations());
    visitor.resize(390, 900, true);
    visitor.await(until);
    assertEquals("[]", visitor.violations());
    assertEquals("", visitor.look("document.getElementById('fault').textContent"));
  }

  @Test
  void list_isSearchedByAWord_andOpensARun() throws Exception {
    visitor.await(
        "document.querySelector('#folders').textContent.includes('" + Samples.MARKUP + "')");
    visitor.await("!document.querySelector('#folders img')");
    visitor.click("#folders input");
    for (String key : List.of("s", "h", "a", "d")) {
      visitor.press(key, key.toUpperCase(java.util.Locale.ROOT).charAt(0));
    }
    visitor.await("document.querySelectorAll('#folders tbody tr').length === 2");
    checkWholeAndForEverybody("document.querySelectorAll('#folders tbody tr').length === 2");
    visitor.click("#folders tbody a");
    visitor.await("document.querySelector('.readout td') !== null");
  }

  @Test
  void run_saysAtABearingWhatTableAndSensorsAre() throws Exception {
    String read = "document.querySelector('.readout h3').textContent";
    show("open=runs%2Fone", "document.querySelector('.readout td') !== null");
    // By the mouse in the plan: to the right is bearing 90.
    String[] right =
        visitor
            .look(
                "(() => { const b = document.querySelector('.sheet').getBoundingClientRect();"
                    + " return [b.x + b.width * 0.7, b.y + b.height / 2].join(); })()")
            .split(",", -1);
    visitor.mouse("mouseMoved", Double.parseDouble(right[0]), Double.parseDouble(right[1]));
    visitor.await(read + " === 'At bearing 90\u00b0'");
    String words = visitor.look("document.querySelector('.readout table').textContent");
    assertTrue(
        words.startsWith(
            "table1.50 minterval1.40 to 1.60 mpings720 in all, 10 at each distanceoriginal"),
        words);
    // By the mouse in a chart, whose neighbour goes along.
    String[] middle =
        visitor
            .look(
                "(() => { document.querySelector('.u-over').scrollIntoView({block: 'center'}); const b = document.querySelector('.u-over').getBoundingClientRect();"
                    + " return [b.x + b.width * 180 / 350, b.y + b.height / 2].join(); })()")
            .split(",", -1);
    visitor.mouse("mouseMoved", Double.parseDouble(middle[0]), Double.parseDouble(middle[1]));
    visitor.await(read + " === 'At bearing 180\u00b0'");
    // By keys.
    visitor.look("document.querySelector('.readout input').focus()");
    visitor.press("ArrowRight", 39);
    visitor.await(read + " === 'At bearing 190\u00b0'");
    visitor.look(KEEP_WHAT_IS_SAVED);
    visitor.click(".twin figure .bar button:nth-child(1)");
    visitor.await(
        "saved.length === 1 && !new DOMParser().parseFromString(saved[0], 'image/svg+xml').querySelector('parsererror')");
    visitor.click(".chartbox .bar button:nth-child(3)");
    visitor.await("saved.length === 2 && saved[1].split('\\n').length === 38");
    // The chart as a picture: a line for each sensor, in its frame, with its name.
    visitor.click(".chartbox .bar button:nth-child(1)");
    visitor.await(
        "saved.length === 3 && new DOMParser().parseFromString(saved[2], 'image/svg+xml').querySelectorAll('svg svg path').length >= 2 && saved[2].includes('>shadow</text>')");
    checkWholeAndForEverybody("document.querySelector('.readout td') !== null");
  }

  @Test
  void run_isComparedWithAnother() throws Exception {
    show("open=runs%2Fone", "document.querySelector('.openhead select') !== null");
    visitor.look(
        "const s = document.querySelector('.openhead select'); s.value = 'runs/two'; s.dispatchEvent(new Event('change'))");
    visitor.await(
        "document.querySelector('.readout') && document.querySelector('.readout').textContent.includes('shadow \u00b7 runs/two')");
    visitor.await("location.hash === '#open=runs%2Fone&with=runs%2Ftwo'");
    checkWholeAndForEverybody("document.querySelector('.readout td') !== null");
  }

  @Test
  void diagnosis_showsTheRowsOfAPlace_beforeAndAfter() throws Exception {
    show("open=diagnoses%2Fwall", "document.querySelector('#places') !== null");
    assertTrue(
        visitor.look("document.querySelector('.verdict').textContent").startsWith("explained"));
    // How far the wall is heard, by the keys.
    visitor.look("document.querySelector('.chart').focus()");
    visitor.press("ArrowRight", 39);
    visitor.press("ArrowRight", 39);
    visitor.await(
        "/^bearing, degrees 10: fitted 2[.][45]\\d*, believed 2[.][45]\\d*$/.test(document.querySelector('.said').textContent)");
    // The row that the mouse points at.
    String[] first =
        visitor
            .look(
                "(() => { const c = document.querySelector('.sheet'); c.scrollIntoView({block: 'center'}); const b = c.getBoundingClientRect(), s = Math.min(b.width, b.height) / 2.838;"
                    + " return [b.x + b.width / 2, b.y + b.height / 2 + (1 - 1.275) * s].join(); })()")
            .split(",", -1);
    visitor.mouse("mouseMoved", Double.parseDouble(first[0]), Double.parseDouble(first[1]));
    visitor.await(
        "/^Row \\d+: range 0.9\\d+ m, bearing/.test(document.querySelector('#rowtip').textContent)");
    visitor.click("#places button:nth-child(2)");
    visitor.await("document.querySelector('#rowsaid').textContent.includes(' 25 rows')");
    visitor.await(
        "document.querySelectorAll('[aria-label=\"Rows of the place\"] tbody tr').length === 25");
    String picture = "document.querySelector('.sheet').toDataURL()";
    String before = visitor.look(picture);
    visitor.look("document.querySelector('#after').focus()");
    visitor.press("End", 35);
    visitor.await("document.querySelector('#after').getAttribute('aria-valuetext') === 'after'");
    visitor.await(picture + " !== '" + before + "'");
    // The points of the chart are dots on the believed line now: none is a centimetre off.
    visitor.look(KEEP_WHAT_IS_SAVED);
    visitor.click("[aria-label=\"Save range-error\"] button:nth-child(3)");
    visitor.await(
        "saved.length === 1 && saved[0].split('\\n').slice(1, -1).every(l => Math.abs(Number(l.split(',')[1])) < 0.2 && Math.abs(Number(l.split(',')[2])) < 0.2)");
    checkWholeAndForEverybody("document.querySelector('#places') !== null");
  }

  @Test
  void diagnoses_batchesAndMotion_areShown() throws Exception {
    show(
        "open=diagnoses%2Fwall&with=diagnoses%2Fagain",
        "document.querySelectorAll('.verdict').length === 2");
    visitor.await("document.querySelector('#rowsaid').textContent.startsWith('All ')");
    visitor.click(".oneof button:nth-child(3)");
    visitor.await(
        "document.querySelector('.oneof button:nth-child(3)').getAttribute('aria-pressed') === 'true' && document.querySelectorAll('#rowsaid').length === 1");
    show("open=motion%2Frobot", "document.querySelectorAll('.bars .fill').length === 18");
    checkWholeAndForEverybody("document.querySelectorAll('.bars .fill').length === 18");
    show("open=batch", "document.querySelectorAll('#folders .fields select').length === 3");
    visitor.look(
        "const y = document.querySelectorAll('#folders .fields select')[1]; y.value = 'edge_kept'; y.dispatchEvent(new Event('change'))");
    visitor.await(
        "document.querySelector('.chartbox figcaption').textContent.startsWith('edge_kept')");
    checkWholeAndForEverybody("document.querySelector('.chart') !== null");
    show("open=captures%2Fpost", "document.querySelector('.readout td') !== null");
    visitor.click(".opened a.watch");
    visitor.await(
        "!document.getElementById('watch').hidden && document.getElementById('captured').textContent === 'post'");
    // The last reading stands there in large type: 5800 us.
    visitor.await("Number(document.getElementById('reading').textContent) > 90");
    assertEquals("[]", visitor.violations());
    visitor.click("#home");
    visitor.await("document.querySelector('.readout td') !== null");
  }

  /** A tenth slower than told: 5 and 9 mm short on the line and on the arc, none after the fit. */
  @Test
  void drive_showsTheWindowsOfAPlace_beforeAndAfter() throws Exception {
    show("open=motion%2Frobot", "document.querySelector('#driveplaces') !== null");
    visitor.await(
        "document.querySelector('#drivesaid').textContent.startsWith('All 80 windows of half a second; along, the mean error is 7.')");
    visitor.click("#driveplaces button:nth-child(3)");
    visitor.await(
        "document.querySelector('#drivesaid').textContent === 'time 0 to 10 s: 40 windows of half a second; along, the mean error is 5.00 mm before, 0.00 mm after.'");
    visitor.await(
        "document.querySelectorAll('[aria-label=\"Windows of the place\"] tbody tr').length === 40");
    // The mouse on the first window, at the origin of the track.
    String picture = "document.querySelector('.sheet').toDataURL()";
    String before = visitor.look(picture);
    visitor.look("document.querySelector('#driveafter').focus()");
    visitor.press("End", 35);
    visitor.await(picture + " !== '" + before + "'");
    visitor.look(KEEP_WHAT_IS_SAVED);
    visitor.click("[aria-label=\"Save motion-error\"] button:nth-child(3)");
    visitor.await(
        "saved.length === 1 && saved[0].split('\\n').slice(1, -1).every(l => Math.abs(Number(l.split(',')[1])) < 0.05 && Math.abs(Number(l.split(',')[2])) < 0.05)");
    visitor.click("[aria-label=\"Save drive\"] button:nth-child(3)");
    visitor.await("saved.length === 2 && saved[1].split('\\n').length === 42");
    // Beside another one: the drive of either, as chosen.
    show("open=motion%2Frobot&with=motion%2Fsecond", "document.querySelector('.oneof') !== null");
    visitor.click("#driveplaces button:nth-child(3)");
    visitor.await("document.querySelector('#drivesaid').textContent.startsWith('time 0 to 10 s')");
    visitor.click(".oneof button:nth-child(3)");
    visitor.await("document.querySelector('#drivesaid').textContent.startsWith('All 80 windows')");
    assertEquals(
        "motion/second",
        visitor.look("document.querySelector('.oneof [aria-pressed=true]').textContent"));
    checkWholeAndForEverybody("document.querySelector('#driveplaces') !== null");
  }

  @Test
  void jointLog_hasBothHalves_andWhatTheyShare() throws Exception {
    show("open=joint%2Fwall", "document.querySelector('#driveplaces') !== null");
    assertTrue(
        visitor
            .look("document.querySelector('[aria-label=\"One cause, one value\"]').textContent")
            .contains("speed-scaleodometry-scalefactor0.9000 (0.8900 to 0.9100)"));
    visitor.click("#places button:nth-child(2)");
    visitor.await("document.querySelector('#rowsaid').textContent.includes(' 25 rows')");
    visitor.await("document.querySelector('#drivesaid').textContent.startsWith('All 80 windows')");
    checkWholeAndForEverybody("document.querySelector('#driveplaces') !== null");
  }

  /** Table, interval and pings of the bearing that is pointed at; compared with another capture. */
  @Test
  void capture_saysAtABearingWhatCameOfHowManyPings() throws Exception {
    String read = "document.querySelector('.readout').textContent";
    show("open=captures%2Fagain", "document.querySelector('.readout td') !== null");
    String[] right =
        visitor
            .look(
                "(() => { const b = document.querySelector('.sheet').getBoundingClientRect();"
                    + " return [b.x + b.width * 0.7, b.y + b.height / 2].join(); })()")
            .split(",", -1);
    visitor.mouse("mouseMoved", Double.parseDouble(right[0]), Double.parseDouble(right[1]));
    visitor.await(
        read
            + ".startsWith('At bearing 90\u00b0threshold1.10') && "
            + read
            + ".includes('pings15 of 30 heard')");
    visitor.await(
        "document.querySelector('[aria-label=\"Distances tried\"]').textContent.includes('1.100105lost')");
    visitor.look("document.querySelector('.readout input').focus()");
    visitor.press("ArrowRight", 39);
    visitor.await(read + ".startsWith('At bearing 180\u00b0thresholdnot measured yet')");
    visitor.look(KEEP_WHAT_IS_SAVED);
    visitor.click("[aria-label=\"Save thresholds\"] button:nth-child(3)");
    visitor.await("saved.length === 1 && saved[0].split('\\n').length === 6");
    show("open=captures%2Fagain&with=captures%2Fpost", read + ".includes('captures/post1.100 m')");
    checkWholeAndForEverybody("document.querySelector('.readout td') !== null");
  }

  /** As fine as the screen shows it, where somebody zooms in. */
  @Test
  void trace_isAskedForAnew_whereSomebodyZooms() throws Exception {
    show("open=runs%2Fone", "document.querySelector('.readout td') !== null");
    visitor.look(
        "window.before = 0; window.asked = () => performance.getEntriesByType('resource').filter(r => r.name.includes('/trace?')).length; document.querySelector('.sheet').focus()");
    for (int i = 0; i < 6; i++) {
      visitor.press("+", 187);
    }
    visitor.await("asked() >= 1");
    visitor.await("document.getElementById('fault').textContent === ''");
    visitor.press("0", 48);
  }

  /** What a diagnosis in the folder left drives in the live world. */
  @Test
  void diagnosedSensorAndRobot_driveInTheLiveWorld() throws Exception {
    show("live", "document.getElementById('rows').children.length === 12");
    assertEquals(
        "shadow diagnosed-again diagnosed-wall",
        visitor.look(
            "[...document.getElementById('sensor0').options].map(o => o.value).join(' ')"));
    assertEquals(
        " wall robot second",
        visitor.look("[...document.getElementById('robot').options].map(o => o.value).join(' ')"));
    visitor.look(
        "for (const [id, v] of [['sensor0', 'diagnosed-wall'], ['robot', 'robot']]) { const e = document.getElementById(id); e.value = v; e.dispatchEvent(new Event('change')); }");
    visitor.await(
        "document.getElementById('name0').textContent.startsWith('diagnosed-wall, moves as robot \u00b7 ')");
    visitor.await("document.getElementById('name0').textContent.endsWith('of 12 hear')");
    String line = visitor.look("document.getElementById('line').textContent");
    assertTrue(line.contains(" --sensor diagnosed:"), line);
    assertTrue(line.contains("diagnoses/wall --robot diagnosed:"), line);
    assertEquals("", visitor.look("document.getElementById('fault').textContent"));
  }

  /** Bars are a picture as others: an SVG whose bars are as long as they say. */
  @Test
  void bars_areSavedAsAPicture() throws Exception {
    show("open=diagnoses%2Fwall", "document.querySelector('#places') !== null");
    visitor.look(KEEP_WHAT_IS_SAVED);
    visitor.click("[aria-label=\"Save gap\"] button:nth-child(1)");
    visitor.click("[aria-label=\"Save parts\"] button:nth-child(1)");
    visitor.click("[aria-label=\"Save parts\"] button:nth-child(2)");
    visitor.await("saved.length === 3");
    visitor.await(
        "saved.slice(0, 2).every(text => !new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror'))");
    // 5 cm of 20 cm: a quarter of 400 pixels.
    visitor.await("saved[0].includes('h100v18') && saved[0].includes('>5.00<')");
    visitor.await("saved[2].startsWith('part,cm,low,high\\nsound-speed,15,12,17')");
  }

  /** Who wants less motion finds the world at rest. */
  @Test
  void reducedMotion_isRespected() throws Exception {
    visitor.lessMotion();
    visitor.look("location.hash = 'live'; location.reload()");
    visitor.await("document.getElementById('rows').children.length === 12");
    visitor.await("document.getElementById('name0').textContent.endsWith('hear')");
    assertEquals("Play", visitor.look("document.getElementById('play').textContent"));
    // By the keys alone: to the button, and on.
    visitor.look("document.getElementById('play').focus()");
    visitor.press(" ", 32);
    visitor.await("document.getElementById('play').textContent === 'Pause'");
    visitor.await("Number(document.getElementById('scrub').value) > 5");
  }

  @Test
  void whatIsNotThere_isSaid() throws Exception {
    show(
        "open=..%2Foutside", "document.getElementById('fault').textContent.includes('../outside')");
    show("folders", "document.getElementById('fault').textContent === ''");
  }
}
