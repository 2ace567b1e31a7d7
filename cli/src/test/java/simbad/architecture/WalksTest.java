package simbad.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The two walks of docs/architecture.md are short, and their stops are types of the project. */
class WalksTest {
  private static final Path PAGE = Path.of("../docs/architecture.md");
  private static final Pattern TYPE = Pattern.compile("`([A-Z]\\w+)`");

  /** The types in the numbered list below the line that begins with some words. */
  private static Set<String> stops(String begin) throws IOException {
    List<String> lines = Files.readAllLines(PAGE);
    List<String> walk =
        lines.stream()
            .dropWhile(line -> !line.startsWith(begin))
            .skip(2)
            .takeWhile(line -> line.matches("(\\d\\.|-) .*"))
            .toList();
    return TYPE.matcher(String.join("\n", walk))
        .results()
        .map(found -> found.group(1))
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  private static Set<String> sources() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of(".."))) {
      return files
          .map(Path::toString)
          .filter(name -> name.contains("/src/main/java/") && name.endsWith(".java"))
          .map(name -> name.substring(name.lastIndexOf('/') + 1, name.length() - 5))
          .collect(Collectors.toSet());
    }
  }

  private static void checkWalk(String begin, String first, String last, int most)
      throws IOException {
    List<String> stops = List.copyOf(stops(begin));
    assertTrue(stops.size() > 10 && stops.size() <= most, stops.size() + " stops: " + stops);
    assertEquals(first, stops.get(0));
    assertEquals(last, stops.get(stops.size() - 1));
    Set<String> sources = sources();
    assertEquals(List.of(), stops.stream().filter(stop -> !sources.contains(stop)).toList());
  }

  @Test
  void tableRowToReading_hasAtMost25Stops() throws IOException {
    checkWalk("The walk of a row of a threshold table", "RunCommand", "Readings", 25);
  }

  @Test
  void readingToVerdict_hasAtMost15Stops() throws IOException {
    checkWalk("The walk of a row of readings.csv", "DiagnoseCommand", "Verdict", 15);
  }

  /** The page says how many there are with all that is asked on the way. */
  @Test
  void readingToVerdict_withAllThatIsAskedOnTheWay() throws IOException {
    Set<String> all = stops("The walk of a row of readings.csv");
    all.addAll(stops("Six more types are asked on the way."));
    assertEquals(21, all.size(), all.toString());
  }
}
