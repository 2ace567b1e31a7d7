package simbad.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * A public type that a jar may have been compiled against is still there, or docs/upgrading.md says
 * where it went.
 */
class UpgradingTest {
  private static final Path PAGE = Path.of("../docs/upgrading.md");
  private static final Pattern CODE = Pattern.compile("`([^`]+)`");

  /** What a type was called, and what it is called now; empty where it is gone. */
  private static Map<String, String> moves() throws IOException {
    Map<String, String> moves = new HashMap<>();
    for (String line : Files.readAllLines(PAGE)) {
      String[] cells = line.split("\\|", -1);
      if (line.startsWith("| `simbad.") && cells.length == 4) {
        moves.put(codes(cells[1]).get(0), typeOf(cells[1], cells[2]));
      } else if (line.startsWith("| `simbad.")) {
        for (String name : codes(cells[3])) {
          String inPackage = codes(cells[1]).get(0) + ".";
          moves.put(inPackage + name, codes(cells[2]).get(0) + "." + name);
        }
      }
    }
    return moves;
  }

  /** A row of the last table says in words what to take instead. */
  private static String typeOf(String was, String cell) {
    List<String> codes = codes(cell);
    boolean isType = codes.size() == 1 && codes.get(0).matches("simbad(\\.[a-z0-9]+)+\\.[A-Z]\\w*");
    assertTrue(isType || cell.strip().length() > 5, was + ": " + cell);
    return isType ? codes.get(0) : "";
  }

  private static List<String> codes(String cell) {
    return CODE.matcher(cell).results().map((MatchResult found) -> found.group(1)).toList();
  }

  private static boolean isThere(String type) {
    return UpgradingTest.class.getResource("/" + type.replace('.', '/') + ".class") != null;
  }

  @Test
  void everyPublicTypeOfOld_isThereOrListed() throws IOException {
    List<String> types;
    try (var in = UpgradingTest.class.getResourceAsStream("/architecture/public-types.txt")) {
      types =
          new String(in.readAllBytes(), StandardCharsets.UTF_8)
              .lines()
              .filter(line -> !line.startsWith("#"))
              .toList();
    }
    assertTrue(types.size() > 400, types.size() + " types");
    Map<String, String> moves = moves();
    List<String> faults = new ArrayList<>();
    for (String type : types) {
      if (!isThere(type) && !moves.containsKey(type)) {
        faults.add(type + " is neither there nor in " + PAGE.getFileName());
      }
    }
    assertEquals("", String.join("\n", faults));
  }

  /** A name that has moved twice is listed where it is now. */
  @Test
  void everyListedPlace_isThere() throws IOException {
    List<String> faults = new ArrayList<>();
    moves()
        .forEach(
            (was, is) -> {
              if (!is.isEmpty() && !isThere(is)) {
                faults.add(was + " is not in " + is);
              }
            });
    assertEquals("", String.join("\n", faults));
  }
}
