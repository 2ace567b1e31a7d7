package simbad.figures.site;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import simbad.figures.markup.Markup;
import simbad.sonar.format.ShippedText;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;

/** The project's pages as a folder of HTML. */
public final class Site {
  private static final String NAME = "Simbad Sonar";
  private static final List<String> FRONT = List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md");

  /** What comes first in a folder; the rest is in the order of the files' names. */
  private static final List<String> FIRST =
      Stream.concat(
              FRONT.stream(), Stream.of("docs/guide/first-run.md", "docs/method/sonar-model.md"))
          .toList();

  /** Folders of pages in the order of the list beside each page, and what they are called there. */
  private static final List<String> FOLDERS =
      List.of("", "docs/guide", "docs/method", "docs", "docs/decisions", "data");

  private static final Map<String, String> NAMES =
      Map.of(
          "",
          "Start",
          "docs/guide",
          "Guides",
          "docs/method",
          "Methods",
          "docs",
          "Reference",
          "docs/decisions",
          "Decisions",
          "data",
          "Data");

  private final Path project;
  private final List<SitePage> pages;

  private Site(Path project, List<SitePage> pages) {
    this.project = project;
    this.pages = pages;
  }

  /**
   * Writes the site.
   *
   * @param project the project's folder
   * @param out an empty folder
   * @return the number of pages
   * @throws NoSuchFileException if a page links to a file that is not there
   */
  public static int write(Path project, Path out) throws IOException {
    Site site = new Site(project, read(project));
    for (SitePage page : site.pages) {
      site.write(page, out);
    }
    site.writeIndex(out);
    for (String name : List.of("site.css", "site.js")) {
      TextFile.write(out.resolve(name), ShippedText.read(Site.class, name));
    }
    return site.pages.size();
  }

  private static List<SitePage> read(Path project) throws IOException {
    List<Path> sources = new ArrayList<>();
    for (String name : FRONT) {
      if (Files.exists(project.resolve(name))) {
        sources.add(project.resolve(name));
      }
    }
    for (String folder : List.of("docs", "data")) {
      try (Stream<Path> found = Files.walk(project.resolve(folder))) {
        found.filter(file -> file.toString().endsWith(".md")).forEach(sources::add);
      }
    }
    List<SitePage> pages = new ArrayList<>();
    for (Path source : sources) {
      pages.add(SitePage.of(project.relativize(source), Files.readString(source)));
    }
    pages.sort(
        Comparator.comparingInt((SitePage page) -> FOLDERS.indexOf(folder(page)))
            .thenComparingInt(Site::rank)
            .thenComparing(page -> page.source().toString()));
    return pages;
  }

  private static int rank(SitePage page) {
    int first = FIRST.indexOf(page.source().toString().replace('\\', '/'));
    return first < 0 ? FIRST.size() : first;
  }

  private static String folder(SitePage page) {
    Path parent = page.source().getParent();
    String folder = parent == null ? "" : parent.toString().replace('\\', '/');
    return folder.startsWith("data") ? "data" : folder;
  }

  private void write(SitePage page, Path out) throws IOException {
    Path target = out.resolve(page.file());
    Files.createDirectories(Objects.requireNonNull(target.getParent()));
    TextFile.write(target, whole(page));
    for (Path linked : page.linked()) {
      if (!linked.toString().endsWith(".md")) {
        copy(page, linked, out);
      } else if (!Files.exists(project.resolve(linked))) {
        throw new NoSuchFileException(page.source() + " links to " + linked);
      }
    }
  }

  private void copy(SitePage page, Path linked, Path out) throws IOException {
    Path source = project.resolve(linked);
    if (!Files.isRegularFile(source)) {
      throw new NoSuchFileException(page.source() + " links to " + linked);
    }
    Path target = out.resolve(linked);
    if (!Files.exists(target)) {
      Files.createDirectories(Objects.requireNonNull(target.getParent()));
      WholeFile.write(target, Files.readAllBytes(source));
    }
  }

  private String whole(SitePage page) {
    String root = "../".repeat(page.source().getNameCount() - 1);
    return """
    <!DOCTYPE html>
    <html lang="en">
    <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <title>%s</title>
    <link rel="stylesheet" href="%ssite.css">
    </head>
    <body>
    <a class="skip" href="#content">Skip to the content</a>
    <nav aria-label="Pages">
    <div role="search">
    <label for="search">Search <small>(key /)</small></label>
    <input id="search" type="search" autocomplete="off" data-root="%s">
    <ul id="found" aria-live="polite"></ul>
    </div>
    <details id="pages" open>
    <summary>All pages</summary>
    %s</details>
    </nav>
    <main id="content">
    %s</main>
    <script src="%ssearch-index.js"></script>
    <script src="%ssite.js"></script>
    </body>
    </html>
    """
        .formatted(
            Markup.escaped(windowTitle(page)),
            root,
            root,
            list(page, root),
            page.html(),
            root,
            root);
  }

  private static String windowTitle(SitePage page) {
    return page.title().equals(NAME) ? NAME : page.title() + " - " + NAME;
  }

  private String list(SitePage current, String root) {
    StringBuilder list = new StringBuilder();
    for (String folder : FOLDERS) {
      list.append("<h2>").append(NAMES.get(folder)).append("</h2>\n<ul>\n");
      for (SitePage page : pages) {
        if (folder(page).equals(folder)) {
          list.append(
              "<li><a href=\"%s%s\"%s>%s</a></li>\n"
                  .formatted(
                      root,
                      page.file(),
                      page.equals(current) ? " aria-current=\"page\"" : "",
                      Markup.escaped(page.title())));
        }
      }
      list.append("</ul>\n");
    }
    return list.toString();
  }

  private void writeIndex(Path out) throws IOException {
    List<Map<String, String>> index =
        pages.stream()
            .map(page -> Map.of("f", page.file(), "t", page.title(), "w", page.text()))
            .<Map<String, String>>map(TreeMap::new)
            .toList();
    TextFile.write(
        out.resolve("search-index.js"),
        "const PAGES = " + new ObjectMapper().writeValueAsString(index) + ";\n");
  }
}
