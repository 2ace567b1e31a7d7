package simbad.experiments.batch;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/** Where the files are that a spec names: as it names them, or their copies in a batch's folder. */
@FunctionalInterface
interface InputPlace {
  /**
   * Finds a file or folder.
   *
   * @param dimension that names it
   * @param position in the dimension, from 1
   * @param name as the spec has it
   */
  Path of(String dimension, int position, Path name);

  /** As the spec names them; relative names start at the spec's own folder. */
  static InputPlace originals(Path specFile) {
    Path folder = specFile.toAbsolutePath().getParent();
    return (dimension, position, name) -> folder == null ? name : folder.resolve(name);
  }

  /** The copies below a folder. */
  static InputPlace copies(Path folder) {
    return (dimension, position, name) -> folder.resolve(copyName(dimension, position, name));
  }

  /** A copy's name, with slashes: two inputs never share one. */
  static String copyName(String dimension, int position, Path name) {
    return dimension + "/" + position + "/" + name.normalize().getFileName();
  }

  /** What a spec names, which must have a name of its own. */
  static Path name(JsonInput where, String text) throws DataFormatException {
    try {
      Path name = Path.of(text).normalize();
      if (name.getFileName() != null && !name.endsWith("..") && !name.toString().isEmpty()) {
        return Path.of(text);
      }
    } catch (InvalidPathException e) {
      // Said below.
    }
    throw where.isNot("the name of a file or folder");
  }
}
