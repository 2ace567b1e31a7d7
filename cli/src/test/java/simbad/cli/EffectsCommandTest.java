package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.effect.MotionForms;
import simbad.sonar.effect.Definitions;

class EffectsCommandTest {
  @Test
  void all_areListed_oneLineEach() {
    Shell shell = Shell.simbad("effects");
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = shell.out().lines().toList();
    int sensing = Definitions.effects().size();
    assertEquals(List.of("", "Effects of a robot's motion:"), lines.subList(sensing, sensing + 2));
    assertEquals(MotionForms.vocabulary().size(), lines.size() - sensing - 2);
    assertTrue(lines.get(sensing + 2).matches("speed-scale +the robot drives .*"), shell.out());
    assertTrue(lines.get(0).matches("sound-speed +sound is faster .*"), lines.get(0));
  }

  /** A table has 72 parameters, and the level law has forms of its own. */
  @Test
  void named_areExplained_inTheOrderOfTheLine() {
    Shell shell = Shell.simbad("effects", "orientation-shadow", "gain");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("orientation-shadow: the threshold"), shell.out());
    assertTrue(shell.out().contains("threshold_25_deg_m 0 to 20, neutral at 2.5; and 66 more\n"));
    String gain =
        """
          form factor: factor 0.2 to 3, neutral at 1
          form of the level model level: gain_db -40 to 40, neutral at 0
        """;
    assertTrue(shell.out().endsWith(gain), shell.out());
  }

  /** The page has the same words as the command. */
  @Test
  void effectsOfMotion_areExplained_asInTheGuide() throws IOException {
    String page = Files.readString(Path.of("../docs/guide/motion.md"));
    for (String word : MotionForms.vocabulary()) {
      Shell shell = Shell.simbad("effects", word);
      assertEquals(0, shell.status(), shell.err());
      String first = shell.out().lines().findFirst().orElseThrow();
      assertEquals(word + ": " + MotionForms.happens(word), first);
      assertTrue(page.contains("| `" + word + "` | " + MotionForms.happens(word) + " |"), word);
    }
    assertTrue(
        Shell.simbad("effects", "turn-bias").out().contains("  form "), "the form of turn-bias");
  }

  @Test
  void mistyped_isRefused_withASuggestion() {
    Shell shell = Shell.simbad("effects", "gian");
    assertEquals(2, shell.status());
    assertTrue(
        shell.err().startsWith("simbad effects: EFFECT: 'gian' is not the name of an effect"),
        shell.err());
    assertTrue(shell.err().contains("gain"), shell.err());
  }
}
