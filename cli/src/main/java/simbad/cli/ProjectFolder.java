package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The folder of the project, where the firmware and the documents are. */
final class ProjectFolder {
  private ProjectFolder() {}

  /**
   * What the launcher says, or the nearest folder above the current one that holds the firmware.
   *
   * @throws IOException if there is none
   */
  static Path find() throws IOException {
    String home = System.getProperty("simbad.home");
    Path folder = Path.of(home == null ? "" : home).toAbsolutePath();
    for (Path at = folder; at != null; at = at.getParent()) {
      if (Files.isDirectory(at.resolve("firmware-pic18"))) {
        return at;
      }
    }
    throw new IOException(
        folder
            + ": the project's folder firmware-pic18 is not there; call ./simbad in a clone of the"
            + " project or in its source archive");
  }
}
