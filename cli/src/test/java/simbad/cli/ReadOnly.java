package simbad.cli;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Has programs meet a folder that they cannot write to. */
final class ReadOnly {
  private ReadOnly() {}

  /**
   * The words before those of a program. For root, whom rights do not bind, the folder is a
   * read-only file system of the program's own; for others it loses its rights.
   */
  static List<String> command(Path folder) throws IOException, InterruptedException {
    if (!Files.isWritable(Path.of("/"))) {
      run("chmod", "-R", "a-w", folder.toString());
      return List.of("env");
    }
    assumeMounts();
    return List.of(
        "unshare",
        "-m",
        "sh",
        "-c",
        "mount --bind -o ro \"$0\" \"$0\" && exec \"$@\"",
        folder.toString());
  }

  /** Ends a test where nobody may mount a file system. */
  static void assumeMounts() throws IOException, InterruptedException {
    int status = run("unshare", "-m", "mount", "-t", "tmpfs", "none", "/mnt");
    assumeTrue(status == 0, "no file systems can be mounted here");
  }

  private static int run(String... command) throws IOException, InterruptedException {
    return new ProcessBuilder(command).inheritIO().start().waitFor();
  }
}
