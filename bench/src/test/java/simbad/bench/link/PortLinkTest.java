package simbad.bench.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The contract over a real pseudo-terminal, and what can be wrong with a port. */
class PortLinkTest extends SerialLinkContract {
  @TempDir Path folder = Path.of("");

  @Override
  Ends open() throws Exception {
    PtyLink pty = PtyLink.open();
    return new Ends(PortLink.open(pty.path()), pty);
  }

  private static void checkRefused(Path path, String message) {
    IOException fault = assertThrows(IOException.class, () -> PortLink.open(path));
    String said = String.valueOf(fault.getMessage());
    assertTrue(said.contains(message), said);
    assertEquals(1, said.lines().count());
  }

  @Test
  void portThatIsNone_isSaid() throws Exception {
    checkRefused(Path.of("/dev/ttyNOWHERE"), "/dev/ttyNOWHERE: there is no such port; ports here");
    checkRefused(Files.writeString(folder.resolve("notes"), "x"), "notes: is not a serial port");
    checkRefused(folder, "is not a serial port");
    checkRefused(Path.of("/dev/null"), "/dev/null: is not a serial port");
  }

  @Test
  void portThatAnotherProgramHolds_isSaid() throws Exception {
    try (PtyLink pty = PtyLink.open();
        PortLink held = PortLink.open(pty.path())) {
      assertEquals(0, held.read(new byte[1], Duration.ZERO));
      checkRefused(pty.path(), "another program holds it");
    }
  }

  @Test
  void linkToAPort_isOpened() throws Exception {
    try (PtyLink pty = PtyLink.open()) {
      Path link = Files.createSymbolicLink(folder.resolve("tty"), pty.path());
      try (PortLink port = PortLink.open(link)) {
        pty.write(new byte[] {42});
        assertEquals(1, port.read(new byte[5], Duration.ofSeconds(20)));
      }
    }
  }

  @Test
  void ports_areListedWithoutPseudoTerminals() {
    assertFalse(PortLink.ports().stream().anyMatch(port -> port.contains("/pts/")));
  }
}
