package simbad.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** The names that old programs rely on are there, but for those that are listed as missing. */
class SignatureTest {
  @Test
  void listedNames_exist() throws IOException {
    assertEquals(
        "",
        lines("signatures.txt").stream()
            .filter(line -> !Signature.parse(line).exists())
            .collect(Collectors.joining("\n")),
        "names without which old programs do not compile");
  }

  @Test
  void names_areListed_once() throws IOException {
    List<String> all = lines("signatures.txt");
    assertEquals(all.size(), all.stream().distinct().count());
  }

  @Test
  void lookup_tellsApart() {
    checkExists(true, "simbad.sim.Agent is public class extends SimpleAgent");
    checkExists(true, "simbad.sim.Agent has public ? getOdometer()");
    checkExists(false, "simbad.sim.Agent is public abstract class extends SimpleAgent");
    checkExists(false, "simbad.sim.Agent has public double getOdometer(int)");
    checkExists(false, "simbad.sim.Agent has public float getOdometer()");
    checkExists(false, "simbad.sim.World has public static final int VIEW_FROM_TOP = 2");
    checkExists(false, "simbad.sim.Nobody is public class");
  }

  private static void checkExists(boolean expected, String line) {
    assertEquals(expected, Signature.parse(line).exists(), line);
  }

  private static List<String> lines(String file) throws IOException {
    InputStream stream = SignatureTest.class.getResourceAsStream("/api/" + file);
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(Objects.requireNonNull(stream), StandardCharsets.UTF_8))) {
      List<String> lines = reader.lines().toList();
      assertFalse(lines.stream().anyMatch(String::isBlank), file);
      return lines;
    }
  }
}
