package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Headless Chromium, in which pages are looked at.
 *
 * @param folder for its files
 */
public record Browser(Path folder) {
  private static final Optional<Path> CHROMIUM =
      Stream.of(System.getenv("PATH").split(File.pathSeparator, -1))
          .flatMap(
              folder ->
                  Stream.of("chromium", "chromium-browser", "google-chrome")
                      .map(name -> Path.of(folder, name)))
          .filter(Files::isExecutable)
          .findFirst();

  /** In the jar of axe-core's makers. */
  private static final String AXE = "axe.min.js";

  /**
   * Says what a reader would see amiss, words over words, words cut off, a wide page, and what axe
   * finds against WCAG 2.1 A and AA.
   */
  static final String PROBE =
      """
      (async () => {
        const found = [];
        const width = document.documentElement.scrollWidth;
        if (width > window.innerWidth) found.push('wide: ' + width);
        for (const svg of document.querySelectorAll('svg')) {
          const box = svg.getBoundingClientRect();
          const texts = [...svg.querySelectorAll('text')].map(t => [t.textContent, t.getBoundingClientRect()]);
          texts.forEach(([a, p], i) => {
            if (p.left < box.left - 1 || p.right > box.right + 1 || p.top < box.top - 1 || p.bottom > box.bottom + 1)
              found.push('cut: ' + a);
            texts.slice(i + 1).forEach(([b, q]) => {
              if (p.left + 1 < q.right && q.left + 1 < p.right && p.top + 3 < q.bottom && q.top + 3 < p.bottom)
                found.push('over each other: ' + a + ' | ' + b);
            });
            if (p.height < 10) found.push('small: ' + a + ' ' + p.height);
          });
        }
        const standard = {preload: false, runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa']};
        for (const {id, nodes} of (await axe.run(document, standard)).violations)
          found.push(id + ': ' + nodes.map(node => node.html).join(' '));
        return '[' + found.join('; ') + ']';
      })()
      """;

  /** False where the machine has none. */
  public static boolean isThere() {
    return CHROMIUM.isPresent();
  }

  /** The checks of axe-core, as a script. */
  static String axe() throws IOException {
    try (InputStream in =
        Objects.requireNonNull(ClassLoader.getSystemResourceAsStream(AXE), "axe-core is missing")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /**
   * Looks at a report on a phone, a desk and a wall, in both themes: nothing is amiss, its first
   * screen is drawn, its paper is the theme's.
   */
  public void look(String page) throws Exception {
    Path file = Files.writeString(folder.resolve("page.html"), page);
    try (Typist typist = Typist.before(file.toUri(), folder)) {
      typist.open(file.toUri());
      for (int width : new int[] {390, 1280, 2560}) {
        for (boolean dark : new boolean[] {false, true}) {
          typist.show(width, dark);
          String seen = width + (dark ? " dark" : " light");
          // What is there does not change with the width in the other theme.
          assertEquals("[]", dark && width > 390 ? "[]" : typist.faults(), seen);
          checkPicture(typist.picture(), dark);
        }
      }
    }
  }

  private static void checkPicture(BufferedImage picture, boolean dark) {
    int width = picture.getWidth();
    long colours =
        IntStream.range(0, width * picture.getHeight())
            .map(i -> picture.getRGB(i % width, i / width))
            .distinct()
            .count();
    assertTrue(colours > 60, "colours: " + colours);
    int paper = picture.getRGB(2, 2) & 0xFFFFFF;
    assertEquals(dark ? 0x161618 : 0xFFFFFF, paper, "the theme's paper");
  }

  /** The command that opens a page. */
  public List<String> command(URI page, int width, boolean dark) throws IOException {
    return List.of(
        CHROMIUM.orElseThrow().toString(),
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--disable-dev-shm-usage",
        "--hide-scrollbars",
        "--enable-logging=stderr",
        "--user-data-dir=" + Files.createTempDirectory(folder, "profile"),
        "--window-size=" + width + ",800",
        "--blink-settings=preferredColorScheme=" + (dark ? 0 : 1),
        page.toString());
  }
}
