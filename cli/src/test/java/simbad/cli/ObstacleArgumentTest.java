package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.obstacles.Catalogue;

class ObstacleArgumentTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void nameOwnTypes() throws IOException {
    Path own = Files.createDirectory(folder.resolve("wedge"));
    Files.writeString(own.resolve("outline.csv"), "x_mm,z_mm\n15,10\n0,-20\n-15,10\n");
    Files.writeString(
        own.resolve("table.csv"), "bearing_deg,threshold_m\n0,1\n90,1\n180,1\n270,1\n");
    System.setProperty(Catalogue.FOLDER_PROPERTY, folder.toString());
  }

  @AfterEach
  void forget() {
    System.clearProperty(Catalogue.FOLDER_PROPERTY);
  }

  @Test
  void ownType_mistyped_isSuggested() {
    Shell shell = Shell.simbad("table", "show", "wegde");
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("leg-pair, wedge, a table's file"), shell.err());
    assertTrue(shell.err().contains("did you mean wedge?"), shell.err());
  }
}
