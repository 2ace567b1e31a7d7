package simbad.blindworld.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/** Files that appear under their names when all of them is written, with faults that name them. */
public final class Output {
  private Output() {}

  /**
   * Writes a text in UTF-8.
   *
   * @param file over one that may be there
   * @param text the whole content
   * @return the file
   * @throws IOException naming the file, which Java leaves out when the disk is full
   */
  public static Path write(Path file, String text) throws IOException {
    Path beside =
        file.resolveSibling(
            ".unfinished-" + ProcessHandle.current().pid() + "-" + UUID.randomUUID());
    try {
      // Under a name that nobody knows before, so that no link is there to be followed.
      Files.write(
          beside,
          text.getBytes(StandardCharsets.UTF_8),
          StandardOpenOption.CREATE_NEW,
          StandardOpenOption.WRITE);
      return Files.move(beside, file, StandardCopyOption.ATOMIC_MOVE);
    } catch (NoSuchFileException e) {
      throw named(new NoSuchFileException(String.valueOf(file.toAbsolutePath().getParent())), e);
    } catch (IOException e) {
      throw named(new FileSystemException(file.toString(), null, reason(e)), e);
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static IOException named(IOException fault, IOException cause) {
    fault.initCause(cause);
    return fault;
  }

  private static String reason(IOException fault) {
    String reason =
        fault instanceof FileSystemException detailed ? detailed.getReason() : fault.getMessage();
    return reason == null ? fault.getClass().getSimpleName() : reason;
  }
}
