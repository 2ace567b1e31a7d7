package simbad.studio.folders;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.function.Predicate;
import simbad.sonar.format.DataFormatException;

/**
 * A folder with what is in it, and nothing outside: neither a name with dots nor a link leads out.
 */
final class Shelf {
  /** More than that nobody looks through in a list. */
  static final int MOST = 1000;

  private static final int DEPTH = 8;
  private static final Path HERE = Path.of("");

  private final Path root;

  private Shelf(Path root) {
    this.root = root;
  }

  /**
   * Opens a folder.
   *
   * @throws DataFormatException if it is none, or may not be read
   */
  static Shelf of(Path folder) throws DataFormatException {
    if (!Files.isDirectory(folder)) {
      throw DataFormatException.inFile(
          folder, Files.exists(folder) ? "is not a folder" : "no such folder");
    }
    try {
      return new Shelf(folder.toRealPath());
    } catch (IOException e) {
      throw DataFormatException.inFile(folder, "cannot be read: " + e.getMessage());
    }
  }

  Path root() {
    return root;
  }

  /**
   * Returns folders that are of some kind, in the order of their names; at most {@value #MOST}.
   * Hidden ones, and folders that are links, are passed by.
   *
   * @param wanted which
   */
  List<Path> find(Predicate<Path> wanted) throws IOException {
    List<Path> found = new ArrayList<>();
    Files.walkFileTree(
        root,
        EnumSet.noneOf(java.nio.file.FileVisitOption.class),
        DEPTH,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            if (!folder.equals(root) && folder.getFileName().toString().startsWith(".")) {
              return FileVisitResult.SKIP_SUBTREE;
            }
            if (wanted.test(folder)) {
              found.add(folder);
            }
            return found.size() < MOST ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException e) {
            return FileVisitResult.CONTINUE;
          }
        });
    found.sort(null);
    return found;
  }

  /** Returns how the page names a folder: from here, with slashes; the folder itself is a dot. */
  String name(Path folder) {
    Path relative = root.relativize(folder);
    if (relative.equals(HERE)) {
      return ".";
    }
    List<String> parts = new ArrayList<>();
    relative.forEach(part -> parts.add(part.toString()));
    return String.join("/", parts);
  }

  /**
   * Finds a folder by such a name.
   *
   * @throws DataFormatException if there is none in here
   */
  Path folder(String name) throws DataFormatException {
    try {
      Path folder = root.resolve(name).normalize();
      if (folder.startsWith(root)
          && Files.isDirectory(folder)
          && folder.toRealPath().equals(folder)) {
        return folder;
      }
    } catch (InvalidPathException | IOException e) {
      // It is answered as any other name of nothing.
    }
    throw DataFormatException.inArgument("path", "there is no folder '" + name + "' in here");
  }

  /**
   * Returns a file of a folder in here.
   *
   * @param name without folders before it
   * @throws DataFormatException if it is a link that leads elsewhere
   */
  static Path file(Path folder, String name) throws DataFormatException {
    Path file = folder.resolve(name);
    try {
      if (!Files.exists(file) || file.toRealPath().startsWith(folder)) {
        return file;
      }
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
    throw DataFormatException.inFile(file, "is a link that leads out of its folder");
  }
}
