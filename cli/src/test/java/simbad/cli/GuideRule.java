package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;

/**
 * What a test does not do in the short check of what a page or a help shows, and why.
 *
 * @param way in which it is treated instead
 * @param subject a line of a page, or a page's name for all of it
 * @param reason for people; of a {@link Way#TESTED} one, its first word is the test's name
 */
record GuideRule(Way way, String subject, String reason) {
  /** What is done instead of running it. */
  enum Way {
    /** The program's own parser takes it; it runs under {@code ./simbad test --full}. */
    LONG,
    /** The program's own parser takes it. */
    PARSED,
    /** The program's own parser takes it, and another test runs it. */
    TESTED,
    /** Nothing: it is no command of the program. */
    SHOWN
  }

  private static final Pattern LINE = Pattern.compile("(\\w+)\\s+(.*?)\\s+# (.*)");

  /** The list of the pages, in guides, or of the help, in help. */
  static List<GuideRule> all(String folder) throws IOException {
    Path list = Path.of("src", "test", "resources", folder, "not-run.txt");
    return Files.readAllLines(list).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(line -> of(list, line))
        .toList();
  }

  private static GuideRule of(Path list, String line) {
    Matcher matcher = LINE.matcher(line);
    if (!matcher.matches()) {
      throw new IllegalArgumentException(list + ": '" + line + "' is not WAY LINE # REASON");
    }
    return new GuideRule(
        Way.valueOf(matcher.group(1).toUpperCase(Locale.ROOT)), matcher.group(2), matcher.group(3));
  }

  /** Fails where the test that is named is not there. */
  void checkTest() throws ReflectiveOperationException {
    String[] test = reason.split("[ ,]", 2)[0].split("\\.", 2);
    String owner = test[0] + "." + test[1].split("\\.", 2)[0];
    String method = test[1].split("\\.", 2)[1];
    assertTrue(
        Stream.of(Class.forName("simbad." + owner).getDeclaredMethods())
            .filter(found -> found.getName().equals(method))
            .anyMatch(
                found ->
                    found.isAnnotationPresent(Test.class)
                        || found.isAnnotationPresent(ParameterizedTest.class)),
        reason);
  }
}
