package simbad.cli.machine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class TestRunTest {
  private static List<String> command(TestRun run, Map<String, String> environment) {
    return run.command(new Machine(Path.of("p"), environment, Path.of("jdk"), 17));
  }

  @Test
  void withoutADisplay_aVirtualOneIsUsed() {
    TestRun run = TestRun.of(List.of());
    assertEquals("xvfb-run", command(run, Map.of()).get(0));
    assertEquals("xvfb-run", command(run, Map.of("DISPLAY", "")).get(0));
    assertEquals("mvn", command(run, Map.of("DISPLAY", ":1")).get(0));
  }

  @Test
  void full_runsTheLongCampaigns() {
    assertTrue(command(TestRun.of(List.of("--full")), Map.of()).contains("-Dsimbad.full=true"));
    assertFalse(command(TestRun.of(List.of()), Map.of()).contains("-Dsimbad.full=true"));
  }

  @Test
  void wordsAfterTwoDashes_areForMaven() {
    TestRun run = TestRun.of(List.of("--", "-pl", "gap", "--full"));
    assertFalse(run.full());
    List<String> command = command(run, Map.of());
    assertEquals(
        List.of("-pl", "gap", "--full"), command.subList(command.size() - 3, command.size()));
    assertTrue(TestRun.of(List.of("--full", "--")).full());
  }

  @Test
  void otherWords_areRefused() {
    IllegalArgumentException fault =
        assertThrows(IllegalArgumentException.class, () -> TestRun.of(List.of("--fulll")));
    assertEquals(
        "test: '--fulll' is not an option of it (see simbad test --help)", fault.getMessage());
  }
}
