package simbad.experiments.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FidelityCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @Test
  void shadowSensor_isFaithful_andLeavesItsTraces() {
    Path out = folder.resolve("out");
    Shell shell = Shell.simbad("fidelity", "round", "--speed", "0.1", "--out", out.toString());
    assertEquals(new Shell(0, "round, shadow: faithful\n", ""), shell);
    assertTrue(Files.exists(out.resolve("round/map.csv")));
    assertTrue(Files.exists(out.resolve("round/trace.csv")));
    assertTrue(Files.exists(out.resolve("errors.json")));
  }

  @Test
  void originalSensor_isNot() {
    Shell shell = Shell.simbad("fidelity", "round", "--sensor", "original", "--speed", "0.1");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("round, original: not faithful: agrees at "), shell.out());
  }

  @Test
  void wrongFigures_areRefused() {
    assertEquals(2, Shell.simbad("fidelity", "round", "--speed", "0").status());
    assertEquals(2, Shell.simbad("fidelity", "round", "--sensor", "ear").status());
    assertEquals(2, Shell.simbad("fidelity", "nothing").status());
  }
}
