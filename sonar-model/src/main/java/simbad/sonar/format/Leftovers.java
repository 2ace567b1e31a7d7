package simbad.sonar.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What a process made for itself and could not delete, because it was killed.
 *
 * <p>Who makes such a folder or file gives it a {@link #name} that says whose it is, and {@link
 * #sweep sweeps} before: so the next one deletes what the ones before left. Only what certainly
 * belongs to nobody any more is deleted: its process ran on this machine and is gone, and its owner
 * is this account.
 */
public final class Leftovers {
  private static final Pattern NAME = Pattern.compile(".*-(" + Owner.FORM + ")-\\d+");
  private static final AtomicLong NUMBER = new AtomicLong();

  private Leftovers() {}

  /**
   * Returns a name that no other process makes, and this one only once.
   *
   * @param stem what it begins with; tells people what it is
   */
  public static String name(String stem) {
    return stem + "-" + Owner.current().mark() + "-" + NUMBER.incrementAndGet();
  }

  /**
   * Deletes the folders and files of such names whose processes are gone. What cannot be deleted is
   * left, without a word.
   *
   * @param folder in which they lie
   */
  public static void sweep(Path folder) {
    try (DirectoryStream<Path> entries =
        Files.newDirectoryStream(folder, entry -> isLeft(entry.getFileName()))) {
      for (Path entry : entries) {
        if (isOurs(entry)) {
          delete(entry);
        }
      }
    } catch (IOException | UncheckedIOException e) {
      // Nothing can be looked for here, or somebody else is sweeping as well.
    }
  }

  private static boolean isLeft(Path name) {
    Matcher matcher = NAME.matcher(name.toString());
    return matcher.matches() && Owner.parse(matcher.group(1)).filter(Owner::isGone).isPresent();
  }

  /** The processes of other accounts may be hidden from this one: they would seem to be gone. */
  private static boolean isOurs(Path entry) throws IOException {
    try {
      Path mine = Path.of("/proc/self");
      return !Files.exists(mine)
          || Files.getOwner(entry, LinkOption.NOFOLLOW_LINKS).equals(Files.getOwner(mine));
    } catch (UnsupportedOperationException e) {
      // A file system without owners.
      return true;
    }
  }

  /**
   * Deletes a file or a folder with all that is in it; links are not followed.
   *
   * @param path of it
   * @return whether it is gone
   */
  public static boolean delete(Path path) {
    try (Stream<Path> entries = Files.walk(path)) {
      List<Path> deepestFirst = entries.sorted(Comparator.reverseOrder()).toList();
      for (Path entry : deepestFirst) {
        Files.deleteIfExists(entry);
      }
    } catch (IOException | UncheckedIOException e) {
      // What is left is seen below.
    }
    return Files.notExists(path, LinkOption.NOFOLLOW_LINKS);
  }
}
