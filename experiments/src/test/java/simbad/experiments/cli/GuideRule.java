package simbad.experiments.cli;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * What a test does not do in the short check of what a page shows, and why.
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

  private static final Path LIST = Path.of("src", "test", "resources", "guides", "not-run.txt");
  private static final Pattern LINE = Pattern.compile("(\\w+)\\s+(.*?)\\s+# (.*)");

  /** The one list. */
  static List<GuideRule> all() throws IOException {
    return Files.readAllLines(LIST).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(GuideRule::of)
        .toList();
  }

  private static GuideRule of(String line) {
    Matcher matcher = LINE.matcher(line);
    if (!matcher.matches()) {
      throw new IllegalArgumentException(LIST + ": '" + line + "' is not WAY LINE # REASON");
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
        Class.forName("simbad.experiments." + owner)
            .getDeclaredMethod(method)
            .isAnnotationPresent(Test.class),
        reason);
  }
}
