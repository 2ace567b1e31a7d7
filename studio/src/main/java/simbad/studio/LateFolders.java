package simbad.studio;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;
import simbad.studio.folders.Folders;

/** A folder that may not be there yet: it is opened when somebody first finds it there. */
final class LateFolders {
  private final Path folder;
  private Optional<Folders> opened = Optional.empty();

  LateFolders(Path folder) {
    this.folder = folder;
  }

  /**
   * Opens it.
   *
   * @throws DataFormatException if it is not there
   */
  synchronized Folders get() throws DataFormatException {
    if (opened.isEmpty()) {
      opened = Optional.of(Folders.of(folder, List.of()));
    }
    return opened.get();
  }
}
