package simbad.figures.diagnosis;

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
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

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
   * Says what a reader would see amiss, errors, words over words, words cut off, a wide page, and
   * what axe finds against WCAG 2.1 A and AA.
   */
  private static final String PROBE =
      """
      <script src="AXE"></script>
      <script>
      {
      const found = [];
      window.onerror = message => found.push('error: ' + message);
      window.onload = async () => {
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
        const out = document.createElement('pre');
        out.id = 'probe';
        out.textContent = '[' + found.join('; ') + ']';
        document.body.appendChild(out);
      };
      }
      </script>
      </body>
      """;

  /** False where the machine has none. */
  public static boolean isThere() {
    return CHROMIUM.isPresent();
  }

  /** Looks at a page: nothing is amiss, its first screen is drawn, its paper is the theme's. */
  public void look(String page, int width, boolean dark) throws IOException, InterruptedException {
    assertEquals("[]", faults(Files.writeString(folder.resolve("page.html"), page), width, dark));
    BufferedImage picture = picture(page, width, dark);
    assertEquals(width, picture.getWidth());
    long colours =
        IntStream.range(0, width * 800)
            .map(i -> picture.getRGB(i % width, i / width))
            .distinct()
            .count();
    assertTrue(colours > 60, "colours: " + colours);
    int paper = picture.getRGB(2, 2) & 0xFFFFFF;
    assertEquals(dark ? 0x161618 : 0xFFFFFF, paper, "the theme's paper");
  }

  /**
   * What a reader would see amiss in a page's file, beside which a copy is written: a list in
   * brackets, empty when nothing is.
   */
  public String faults(Path page, int width, boolean dark)
      throws IOException, InterruptedException {
    String whole = Files.readString(page);
    assertTrue(whole.endsWith("</body>\n</html>\n"), page + " ends in another way");
    String probe = PROBE.replace("AXE", axe().toUri().toString());
    Path probed =
        Files.writeString(page.resolveSibling("probed.html"), whole.replace("</body>\n", probe));
    String dom = chromium(probed, width, dark, "--dump-dom", "--virtual-time-budget=60000");
    Matcher said = Pattern.compile("<pre id=\"probe\">(.*?)</pre>", Pattern.DOTALL).matcher(dom);
    assertTrue(said.find(), dom);
    assertEquals(
        List.of(), dom.lines().filter(line -> line.contains(":CONSOLE:")).toList(), "errors");
    return said.group(1);
  }

  private Path axe() throws IOException {
    Path script = folder.resolve(AXE);
    try (InputStream in =
        Objects.requireNonNull(ClassLoader.getSystemResourceAsStream(AXE), "axe-core is missing")) {
      Files.copy(in, script, StandardCopyOption.REPLACE_EXISTING);
    }
    return script;
  }

  /** The first screen, 800 pixels high. */
  private BufferedImage picture(String page, int width, boolean dark)
      throws IOException, InterruptedException {
    Path plain = Files.writeString(folder.resolve("plain.html"), page);
    Path png = folder.resolve("page.png");
    chromium(plain, width, dark, "--screenshot=" + png);
    return ImageIO.read(png.toFile());
  }

  /** The command that opens a page's file. */
  public List<String> command(Path page, int width, boolean dark) throws IOException {
    return command(page.toUri(), width, dark);
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

  /** Returns what Chromium prints on both streams. */
  private String chromium(Path page, int width, boolean dark, String... what)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(command(page, width, dark));
    command.addAll(List.of(what));
    Path output = Files.createTempFile(folder, "output", ".txt");
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    boolean ended = process.waitFor(2, TimeUnit.MINUTES);
    process.destroyForcibly();
    String text = Files.readString(output, StandardCharsets.ISO_8859_1);
    assertTrue(ended && process.exitValue() == 0, text);
    return text;
  }
}
