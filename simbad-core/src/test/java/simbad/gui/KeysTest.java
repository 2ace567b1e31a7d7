package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The window's help and the guide name the same keys. */
class KeysTest {
  private static final Path GUIDE = Path.of("..", "docs", "guide", "window.md");

  @Test
  void help_isTheTableOfTheGuide() throws IOException {
    List<String> help = rows("<tr><td>(.*)</td><td>(.*)</td></tr>", Menus.CONTROLS);
    assertTrue(help.size() > 10);
    assertEquals(
        help,
        rows("(?m)^\\| ([^|]+) \\| ([^|]+) \\|$", Files.readString(GUIDE)).stream()
            .filter(row -> !row.startsWith("mouse and keys"))
            .toList());
  }

  private static List<String> rows(String pattern, String text) {
    return Pattern.compile(pattern).matcher(text).results().map(KeysTest::row).toList();
  }

  private static String row(MatchResult row) {
    return row.group(1) + ": " + row.group(2);
  }
}
