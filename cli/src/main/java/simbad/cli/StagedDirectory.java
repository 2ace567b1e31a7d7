package simbad.cli;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.stream.Stream;
import simbad.sonar.format.Leftovers;

/**
 * A directory of results that appears under its name only when all of it is written.
 *
 * <p>Until then the files stand in a directory beside it. That directory is deleted when the
 * command fails, and when the process is told to end (Ctrl-C); after a kill, by the next that
 * writes there. Thread-safe.
 */
final class StagedDirectory implements AutoCloseable {
  private final Path target;
  private final Path staging;
  private final Ending discardAtEnd;
  private boolean open;
  private boolean discarded;

  private StagedDirectory(Path target, Path staging) {
    this.target = target;
    this.staging = staging;
    this.discardAtEnd = Ending.with(this::discard);
  }

  /**
   * Makes the directory to write to.
   *
   * @param target where the results shall be; its parents are made
   * @throws FileAlreadyExistsException when something is there already, except an empty directory
   * @throws IOException when no directory can be made there
   */
  static StagedDirectory beside(Path target) throws IOException {
    Path absolute = target.toAbsolutePath().normalize();
    if (!isFree(absolute)) {
      throw new FileAlreadyExistsException(target.toString());
    }
    Path parent = absolute.getParent();
    Path name = absolute.getFileName();
    if (parent == null || name == null) {
      throw new FileAlreadyExistsException(target.toString());
    }
    Leftovers.sweep(parent);
    Path staging = parent.resolve(Leftovers.name("." + name + ".unfinished"));
    StagedDirectory staged = new StagedDirectory(absolute, staging);
    boolean made = false;
    try {
      staged.make();
      made = true;
      return staged;
    } catch (AccessDeniedException e) {
      throw new AccessDeniedException(target.toString());
    } catch (NoSuchFileException e) {
      // Folders of the system's own, such as those of its processes, are no place for files.
      throw new FileSystemException(target.toString(), null, "no directory can be made there");
    } finally {
      if (!made) {
        staged.close();
      }
    }
  }

  private synchronized void make() throws IOException {
    if (discarded) {
      throw new FileSystemException(target.toString(), null, "the program is ending");
    }
    Files.createDirectories(staging.getParent());
    Files.createDirectory(staging);
    open = true;
  }

  /** True when nothing is there or an empty directory. */
  private static boolean isFree(Path path) throws IOException {
    if (!Files.isDirectory(path)) {
      return Files.notExists(path, LinkOption.NOFOLLOW_LINKS);
    }
    try (Stream<Path> entries = Files.list(path)) {
      return entries.findAny().isEmpty();
    }
  }

  /** Where to write. */
  Path path() {
    return staging;
  }

  /**
   * Gives the directory its name; nothing may be written to it afterwards.
   *
   * @throws IOException when meanwhile something else has that name
   */
  synchronized void publish() throws IOException {
    if (!open) {
      throw new IllegalStateException("published or closed already: " + target);
    }
    try {
      // Replaces an empty directory and nothing else.
      Files.move(staging, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileSystemException e) {
      // The system's reason for this one differs from one file system to the next.
      throw isFree(target) ? e : new FileAlreadyExistsException(target.toString());
    }
    open = false;
  }

  /** Deletes what was not published. */
  @Override
  public void close() {
    discard();
    discardAtEnd.close();
  }

  private synchronized void discard() {
    discarded = true;
    // A command that is being interrupted may still write a file while the others go.
    for (int attempt = 0; open && attempt < 3; attempt++) {
      open = !Leftovers.delete(staging);
    }
    open = false;
  }
}
