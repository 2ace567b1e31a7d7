package simbad.figures.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SiteTest {
  private static final Pattern LINK = Pattern.compile("(?:href|src)=\"([^\"#]+)(?:#([^\"]*))?\"");

  private static final Pattern ANCHOR = Pattern.compile("href=\"([^\"#:]*)#([^\"]*)\"");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static List<Path> pages(Path site) throws IOException {
    try (Stream<Path> files = Files.walk(site)) {
      return files.filter(file -> file.toString().endsWith(".html")).toList();
    }
  }

  /** Of the project's own pages. */
  @Test
  void everyLink_leadsSomewhere() throws IOException {
    int count = Site.write(Path.of(".."), folder);
    List<Path> pages = pages(folder);
    assertEquals(count, pages.size());
    for (Path page : pages) {
      LINK.matcher(Files.readString(page))
          .results()
          .map(link -> link.group(1))
          .filter(link -> !SitePage.isOutside(link))
          .forEach(
              link ->
                  assertTrue(
                      Files.isRegularFile(Objects.requireNonNull(page.getParent()).resolve(link)),
                      page + " -> " + link));
    }
    for (Path page : pages) {
      checkAnchors(page);
    }
    assertTrue(Files.readString(folder.resolve("search-index.js")).startsWith("const PAGES = [{"));
  }

  private static void checkAnchors(Path page) throws IOException {
    for (MatchResult link : ANCHOR.matcher(Files.readString(page)).results().toList()) {
      Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1));
      assertTrue(
          Files.readString(target).contains("id=\"" + link.group(2) + "\""),
          page + " -> " + link.group());
    }
  }

  /** The first run before the other guides, what a sonar hears before the other methods. */
  @Test
  void list_beginsWithWhatComesFirst() throws IOException {
    Site.write(Path.of(".."), folder);
    String index = Files.readString(folder.resolve("index.html"));
    assertTrue(index.indexOf(">The first run<") < index.indexOf(">Thousands of runs<"));
    assertTrue(index.indexOf(">What a sonar hears<") < index.indexOf(">The withheld check<"));
  }

  @Test
  void write_brokenLink_namesPageAndTarget() throws IOException {
    Path project = Files.createDirectories(folder.resolve("project"));
    Files.createDirectories(project.resolve("docs"));
    Files.createDirectories(project.resolve("data"));
    Files.writeString(project.resolve("README.md"), "# A\n[b](docs/none.md)\n");
    Path out = Files.createDirectory(folder.resolve("out"));
    NoSuchFileException fault =
        assertThrows(NoSuchFileException.class, () -> Site.write(project, out));
    assertEquals("README.md links to " + Path.of("docs", "none.md"), fault.getMessage());
  }

  @Test
  void page_withAnchorsAndMarks_isHtml() {
    SitePage page =
        SitePage.of(Path.of("docs/x.md"), "# A < B\n\n[c](../README.md#d) ![e](f.png)\n");
    assertEquals("A < B", page.title());
    assertEquals("docs/x.html", page.file());
    assertTrue(page.html().contains("<a href=\"../index.html#d\">c</a>"), page.html());
    assertEquals(List.of(Path.of("README.md"), Path.of("docs/f.png")), page.linked());
  }
}
