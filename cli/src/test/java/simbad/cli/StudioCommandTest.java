package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What {@code simbad studio} refuses before it opens a page. */
class StudioCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static void checkRefused(String named, String... arguments) {
    String[] all = new String[arguments.length + 1];
    all[0] = "studio";
    System.arraycopy(arguments, 0, all, 1, arguments.length);
    Shell shell = Shell.simbad(all);
    assertEquals(2, shell.status(), shell.err());
    assertEquals("", shell.out());
    assertEquals(1, shell.err().lines().count(), shell.err());
    assertTrue(shell.err().contains(named), shell.err());
  }

  @Test
  void whatIsNotThere_isNamed() throws Exception {
    checkRefused("no-such-folder", folder.resolve("no-such-folder").toString());
    checkRefused("scene.json", "--scene", folder.resolve("scene.json").toString());
    checkRefused("--data", "--data", folder.toString());
    checkRefused("--port", "--port", "65536");
    checkRefused("motion.json", "--robot", "diagnosed:" + folder);
    checkRefused("nothing", "--sensor", "nothing");
  }

  @Test
  void sceneOfOtherChoices_isNamedByItsField() throws Exception {
    Path scene = folder.resolve("scene.json");
    Files.writeString(
        scene,
        """
        {"format": "simbad-studio/1", "obstacle": "angle", "sensor": "diagnosed-mine",
         "speed_m_per_s": 0.01, "seed": 1, "moves": []}
        """);
    checkRefused("sensor", "--scene", scene.toString());
  }
}
