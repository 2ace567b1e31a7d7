package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.effect.Definitions;

class EffectsCommandTest {
  @Test
  void all_areListed_oneLineEach() {
    Shell shell = Shell.simbad("effects");
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = shell.out().lines().toList();
    assertEquals(Definitions.effects().size(), lines.size());
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

  @Test
  void mistyped_isRefused_withASuggestion() {
    Shell shell = Shell.simbad("effects", "gian");
    assertEquals(2, shell.status());
    assertTrue(
        shell.err().startsWith("simbad effects: 'gian' is not the name of an effect"), shell.err());
    assertTrue(shell.err().contains("gain"), shell.err());
  }
}
