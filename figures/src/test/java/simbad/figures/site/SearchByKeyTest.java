package simbad.figures.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.figures.page.Browser;
import simbad.figures.page.Typist;

/** The pages' search in headless Chromium, with nothing but the keyboard. */
@Timeout(180)
class SearchByKeyTest {
  private static final String IN_BOX = "document.activeElement.id === 'search'";
  private static final String AT_HIT =
      "[...document.querySelectorAll('#found a')].indexOf(document.activeElement)";
  private static final String HITS = "document.querySelectorAll('#found a').length";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void write() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the search is not tried");
    Files.createDirectories(folder.resolve("site"));
    Site.write(Path.of(".."), folder.resolve("site"));
  }

  private Typist typist() throws Exception {
    Typist typist = Typist.before(folder.resolve("site/index.html").toUri(), folder);
    // Before the page there is an empty one, which is complete as well.
    typist.await("typeof reachable === 'function' && document.readyState === 'complete'");
    return typist;
  }

  @Test
  void slash_goesToTheSearch_escapeEndsIt() throws Exception {
    try (Typist typist = typist()) {
      typist.press("/");
      assertEquals("true", typist.look(IN_BOX));
      assertEquals("", typist.look("box.value"));
      typist.type("threshold 40");
      assertEquals("threshold 40", typist.look("box.value"));
      assertTrue(Integer.parseInt(typist.look(HITS)) >= 2, typist.look("found.textContent"));
      typist.press("ArrowDown");
      assertEquals("0", typist.look(AT_HIT));
      typist.press("ArrowDown");
      assertEquals("1", typist.look(AT_HIT));
      typist.press("ArrowUp");
      typist.press("ArrowUp");
      assertEquals("true", typist.look(IN_BOX));
      typist.press("ArrowDown");
      typist.press("Escape");
      assertEquals("true", typist.look(IN_BOX));
      assertEquals("", typist.look("box.value"));
      assertEquals("0", typist.look(HITS));
      typist.type("a/b");
      assertEquals("a/b", typist.look("box.value"), "in the box a slash is a slash");
    }
  }

  @Test
  void arrowsPastTheLastHit_stayThere() throws Exception {
    try (Typist typist = typist()) {
      typist.press("/");
      typist.type("sonar");
      int hits = Integer.parseInt(typist.look(HITS));
      for (int i = 0; i < hits + 3; i++) {
        typist.press("ArrowDown");
      }
      assertEquals(hits - 1, Integer.parseInt(typist.look(AT_HIT)));
    }
  }

  @Test
  void enterInTheBox_opensTheFirstHit() throws Exception {
    try (Typist typist = typist()) {
      typist.press("/");
      typist.type("simbad batch spec");
      String first = typist.look("document.querySelector('#found a').href");
      typist.press("Enter");
      typist.await("location.href === '" + first + "' && document.readyState === 'complete'");
      assertTrue(first.endsWith(".html") && !first.endsWith("index.html"), first);
    }
  }

  @Test
  void enterAtAHit_opensIt() throws Exception {
    try (Typist typist = typist()) {
      typist.press("/");
      typist.type("robot");
      typist.press("ArrowDown");
      typist.press("ArrowDown");
      String second = typist.look("document.activeElement.href");
      assertTrue(second.startsWith("file:"), second);
      typist.press("Enter");
      typist.await("location.href === '" + second + "'");
    }
  }
}
