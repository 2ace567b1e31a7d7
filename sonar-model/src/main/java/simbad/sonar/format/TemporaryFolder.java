package simbad.sonar.format;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.HashSet;
import java.util.Set;

/**
 * A folder of a process's own for as long as it is needed. What is left of it when the process is
 * killed, the next one that makes such a folder there deletes. Thread-safe.
 */
public final class TemporaryFolder implements AutoCloseable {
  /** Somebody may still be writing to it while it is deleted. */
  private static final int ATTEMPTS = 3;

  private static final int MOST_GUESSED = 100;
  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rwx------");

  private static final Set<TemporaryFolder> OPEN = new HashSet<>();
  private static boolean ending;

  private final Path path;

  private TemporaryFolder(Path path) {
    this.path = path;
  }

  /**
   * Makes one where the system has its temporary files.
   *
   * @param stem what its name begins with
   * @throws IOException if it cannot be made
   */
  public static TemporaryFolder create(String stem) throws IOException {
    return in(Path.of(System.getProperty("java.io.tmpdir")), stem);
  }

  /**
   * Makes one in another folder.
   *
   * @param parent that is there
   * @param stem what its name begins with
   * @throws IOException if it cannot be made
   */
  public static TemporaryFolder in(Path parent, String stem) throws IOException {
    Leftovers.sweep(parent);
    synchronized (OPEN) {
      if (ending) {
        throw new IOException(parent + ": the program is ending, no folder is made");
      }
      TemporaryFolder folder = new TemporaryFolder(made(parent, stem));
      OPEN.add(folder);
      return folder;
    }
  }

  /**
   * For this account alone. Not by the system's own way, whose names are so long that a socket in
   * it might have none.
   */
  private static Path made(Path parent, String stem) throws IOException {
    FileAttribute<?>[] attributes =
        parent.getFileSystem().supportedFileAttributeViews().contains("posix")
            ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNER_ONLY)}
            : new FileAttribute<?>[] {};
    for (int attempt = 1; ; attempt++) {
      try {
        return Files.createDirectory(parent.resolve(Leftovers.name(stem)), attributes);
      } catch (FileAlreadyExistsException e) {
        // Somebody guessed the name: the next one, but not for ever.
        if (attempt == MOST_GUESSED) {
          throw e;
        }
      }
    }
  }

  /** Deletes all that are there, and lets no other be made: for the end of the process. */
  public static void closeAll() {
    Set<TemporaryFolder> left;
    synchronized (OPEN) {
      ending = true;
      left = Set.copyOf(OPEN);
    }
    left.forEach(TemporaryFolder::close);
  }

  /** Returns where it is. */
  public Path path() {
    return path;
  }

  /** Deletes it; what cannot be deleted is left, without a word. */
  @Override
  public void close() {
    for (int attempt = 0; attempt < ATTEMPTS && !Leftovers.delete(path); attempt++) {
      Thread.onSpinWait();
    }
    synchronized (OPEN) {
      OPEN.remove(this);
    }
  }
}
