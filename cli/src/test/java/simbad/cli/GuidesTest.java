package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Every page of the project as a newcomer takes it: commands are typed, files saved, code compiled,
 * what is printed compared. What is not done, and why, stands in {@code guides/not-run.txt}.
 */
class GuidesTest {
  private static final Path PROJECT = Path.of("..");
  private static final Path LOG = Path.of("src", "test", "resources", "guides", "AngleRobot.log");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @SuppressWarnings("NullAway.Init")
  private GuideReading reader;

  private static List<String> pages() throws IOException {
    List<String> pages = new ArrayList<>(List.of("README.md", "CONTRIBUTING.md"));
    for (String folder : List.of("docs", "data")) {
      try (Stream<Path> found = Files.walk(PROJECT.resolve(folder))) {
        found
            .filter(file -> file.toString().endsWith(".md"))
            .map(file -> PROJECT.relativize(file).toString())
            .sorted()
            .forEach(pages::add);
      }
    }
    return pages;
  }

  /** One folder and one terminal for all pages, as a reader has. */
  @BeforeEach
  void open() throws IOException {
    reader =
        new GuideReading(
            GuideShell.in(folder, PROJECT.resolve("data"), PROJECT.resolve("docs")),
            GuideRule.all("guides"));
    // A log of the reader's own.
    Files.copy(LOG, folder.resolve("AngleRobot.log"));
  }

  @AfterEach
  void close() throws IOException {
    reader.close();
  }

  @TestFactory
  Stream<DynamicTest> everyPage_doesWhatItSays() throws IOException {
    return Stream.concat(
        pages().stream().map(page -> dynamicTest(page, () -> reader.read(page, false))),
        Stream.of(
            dynamicTest(
                "every line of not-run.txt", () -> assertEquals(List.of(), reader.unused()))));
  }

  /** With the commands that take minutes. */
  @Tag("full")
  @TestFactory
  Stream<DynamicTest> everyPage_doesWhatItSays_atLength() throws IOException {
    return pages().stream().map(page -> dynamicTest(page, () -> reader.read(page, true)));
  }

  @Test
  void words_areTheShells() {
    assertEquals(List.of("a", "b c", "--d=e f"), List.of(GuideShell.words("a \"b c\"  --d='e f'")));
  }
}
