package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A report under mouse and keys in headless Chromium; one browser for all. */
@Timeout(180)
class PageInHandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Path file;

  @SuppressWarnings("NullAway.Init")
  private static Typist typist;

  @BeforeAll
  static void write() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the page is not tried");
    file = Files.writeString(folder.resolve("page.html"), SamplePage.html());
    typist = Typist.before(file.toUri(), folder);
  }

  @BeforeEach
  void open() throws Exception {
    typist.allowScripts(true);
    typist.open(file.toUri());
    typist.show(1280, false);
  }

  @AfterAll
  static void close() {
    if (typist != null) {
      typist.close();
    }
  }

  private static String view(int number) {
    return "document.querySelectorAll(\"figure\")[" + number + "]";
  }

  private static String said(int number) throws Exception {
    return typist.look(view(number) + ".querySelector('output').textContent");
  }

  private static String seen(int number) throws Exception {
    return typist.look(view(number) + ".querySelector('svg').getAttribute('viewBox')");
  }

  private static void focus(int number) throws Exception {
    typist.look(view(number) + ".querySelector('.view').focus()");
  }

  @Test
  void pointing_tellsTheMark_leavingForgetsIt() throws Exception {
    typist.pointAt("rect.after:nth-of-type(2)");
    assertEquals("bar 1 is 6", said(0));
    typist.pointAt("h2");
    assertTrue(said(0).startsWith("Point at it"), said(0));
  }

  @Test
  void arrows_goFromMarkToMark() throws Exception {
    focus(0);
    typist.press("ArrowRight");
    assertEquals("bar 0 is 3", said(0));
    typist.press("ArrowRight");
    typist.press("ArrowRight");
    assertEquals("bar 2 is 9", said(0));
    typist.press("ArrowRight");
    assertEquals("bar 2 is 9", said(0), "there is none further on");
    typist.press("Home");
    assertEquals("bar 0 is 3", said(0));
    assertEquals("1", typist.look("document.querySelectorAll('.lit').length"));
    typist.press("Escape");
    assertEquals("0", typist.look("document.querySelectorAll('.lit').length"));
  }

  @Test
  void tablesRows_areReadAlongTheAxis() throws Exception {
    typist.pointAt("figure:nth-of-type(2) svg");
    assertTrue(said(1).matches("bearing, degrees (30|60), error, cm 1.[36]0"), said(1));
    focus(1);
    typist.press("End");
    assertEquals("bearing, degrees 90, error, cm 1.90", said(1));
    typist.press("ArrowLeft");
    assertEquals("bearing, degrees 60, error, cm 1.60", said(1));
    assertEquals(
        "M250 4V196", typist.look(view(1) + ".querySelector('.cursor').getAttribute('d')"));
  }

  @Test
  void cells_areReadRoundTheCentre() throws Exception {
    focus(2);
    typist.press("ArrowDown");
    assertEquals("bearing 0°, 0.0 to 0.5 m: 1.5 cm", said(2));
    typist.press("ArrowDown");
    assertEquals("bearing 0°, 0.5 to 1.0 m: 5.5 cm", said(2));
    typist.press("Home");
    typist.press("ArrowRight");
    assertEquals("bearing 90°, 0.0 to 0.5 m: 2.5 cm", said(2));
  }

  @Test
  void keysZoom_andShowAllAgain() throws Exception {
    focus(2);
    typist.press("+");
    assertEquals("33.333 33.333 133.333 133.333", seen(2));
    assertEquals(
        "1.5", typist.look(view(2) + ".querySelector('svg').style.getPropertyValue('--zoom')"));
    typist.press("-");
    assertEquals("0 0 200 200", seen(2));
    for (int i = 0; i < 9; i++) {
      typist.press("+");
    }
    assertTrue(seen(2).endsWith(" 12.5 12.5"), "sixteen times at most: " + seen(2));
    typist.press("0");
    assertEquals("0 0 200 200", seen(2));
  }

  @Test
  void buttonsZoom_andHaveNames() throws Exception {
    String button = view(2) + ".querySelectorAll('button')";
    typist.look(button + "[0].click()");
    assertEquals("33.333 33.333 133.333 133.333", seen(2));
    typist.look(button + "[2].click()");
    assertEquals("0 0 200 200", seen(2));
    assertEquals("Zoom in: Cells", typist.look(button + "[0].getAttribute('aria-label')"));
    String label = typist.look(view(2) + ".querySelector('.view').getAttribute('aria-label')");
    assertTrue(label.startsWith("Cells. Arrow keys read its values"), label);
  }

  private static final String KEEP_WHAT_IS_SAVED =
      "window.saved = []; const make = URL.createObjectURL;"
          + " URL.createObjectURL = blob => { blob.text().then(text => saved.push(text)); return make(blob); }; 1";

  /** Each picture as an SVG of its own, which needs no style sheet; the numbers of each as csv. */
  @Test
  void picturesAndNumbersAreSaved() throws Exception {
    typist.look(KEEP_WHAT_IS_SAVED);
    for (int i = 0; i < 3; i++) {
      typist.look(view(i) + ".querySelector('[aria-label^=\"Save as SVG\"]').click()");
      typist.look("new Promise(done => setTimeout(done, 100))");
      String picture =
          "new DOMParser().parseFromString(saved[%d], 'image/svg+xml').documentElement"
              .formatted(i);
      assertEquals("svg", typist.look(picture + ".nodeName"));
      assertEquals("0", typist.look(picture + ".querySelectorAll('[class]').length"));
      assertEquals(
          "true",
          typist.look(
              "[..."
                  + picture
                  + ".querySelectorAll('path, rect')].every(s => s.style.fill !== '')"));
    }
    typist.look("saved.length = 0");
    for (int i = 0; i < 3; i++) {
      typist.look(view(i) + ".querySelector('[aria-label^=\"Save numbers\"]').click()");
      typist.look("new Promise(done => setTimeout(done, 100))");
    }
    assertEquals(
        "shown\n\"bar 0 is 3\"\n\"bar 1 is 6\"\n\"bar 2 is 9\"\n", typist.look("saved[0]"));
    assertTrue(typist.look("saved[1]").endsWith("\n60,1.60\n90,1.90\n"), typist.look("saved[1]"));
    assertTrue(typist.look("saved[2]").startsWith("bearing_deg,ring,cm\n0,1,1.5\n90,1,2.5\n"));
    assertEquals(
        "1", typist.look("document.querySelectorAll('[aria-label^=\"Save table\"]').length"));
  }

  /** Bars that are no drawing on the page become one: a quarter of 400 pixels. */
  @Test
  void barsAreSavedAsADrawing() throws Exception {
    typist.look(KEEP_WHAT_IS_SAVED);
    typist.look("document.querySelectorAll('.panel button').forEach(button => button.click())");
    typist.look("new Promise(done => setTimeout(done, 200))");
    assertTrue(
        typist.look("saved[0]").contains("<rect x=\"200\" y=\"40\" width=\"100.0\""),
        typist.look("saved[0]"));
    assertEquals("\"one\",\"25 %\"\n", typist.look("saved[1]"));
  }

  /** The page scrolls on over a picture that nobody has taken hold of. */
  @Test
  void wheel_zoomsWhatIsHeld_andNothingElse() throws Exception {
    typist.wheel("figure:nth-of-type(3) svg", -100);
    assertEquals("0 0 200 200", seen(2));
    focus(2);
    typist.wheel("figure:nth-of-type(3) svg", -100);
    assertTrue(seen(2).endsWith(" 166.667 166.667"), seen(2));
  }

  @Test
  void whatIsReadWithKeys_comesIntoSight() throws Exception {
    focus(2);
    for (int i = 0; i < 5; i++) {
      typist.press("+");
    }
    typist.press("End");
    assertEquals("bearing 270°, 0.5 to 1.0 m: 8.5 cm", said(2));
    String box =
        "(b => b.x <= 40 && 40 <= b.x + b.width)("
            + view(2)
            + ".querySelector('svg').viewBox.baseVal)";
    assertEquals("true", typist.look(box));
  }

  /** Everything that is read stands in the page itself. */
  @Test
  void withoutScripts_picturesAndTablesAreThere() throws Exception {
    typist.allowScripts(false);
    typist.open(file.toUri());
    assertEquals("0", typist.look("document.querySelectorAll('.view, button').length"));
    assertEquals(
        "true",
        typist.look(
            "[...document.querySelectorAll('figure > svg')].every(s => s.clientWidth > 200)"));
    typist.look("document.querySelector('details').open = true");
    assertEquals("4", typist.look("document.querySelectorAll('#rows tbody tr').length"));
    assertEquals(
        "bar 1 is 6", typist.look("document.querySelectorAll('rect > title')[1].textContent"));
  }

  /** On paper everything is open, whole and dark on white, whatever the reader's theme. */
  @Test
  void paper_isLight_andHasNoButtons() throws Exception {
    typist.show(1280, true);
    typist.print();
    assertEquals(
        "rgb(255, 255, 255)", typist.look("getComputedStyle(document.body).backgroundColor"));
    assertEquals("none", typist.look("getComputedStyle(document.querySelector('.tools')).display"));
    typist.look("dispatchEvent(new Event('beforeprint'))");
    assertEquals("0", typist.look("document.querySelectorAll('details:not([open])').length"));
    typist.look("dispatchEvent(new Event('afterprint'))");
    assertEquals("1", typist.look("document.querySelectorAll('details:not([open])').length"));
  }

  /** Who asks for no motion gets none: there is none. */
  @Test
  void nothingMoves() throws Exception {
    String moving =
        "[...document.querySelectorAll('*')].map(e => getComputedStyle(e)).filter("
            + "s => s.transitionDuration !== '0s' || s.animationName !== 'none').length";
    assertEquals("0", typist.look(moving));
  }

  @ParameterizedTest
  @CsvSource({"390, false", "390, true", "1280, true", "2560, false"})
  void page_isWholeAndForEverybody(int width, boolean dark) throws Exception {
    typist.show(width, dark);
    assertEquals("[]", typist.faults());
  }
}
