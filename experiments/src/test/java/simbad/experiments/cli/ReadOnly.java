package simbad.experiments.cli;

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
    assumeTrue(run("unshare", "-m", "true") == 0, "no file systems can be mounted here");
    return List.of(
        "unshare",
        "-m",
        "sh",
        "-c",
        "mount --bind -o ro \"$0\" \"$0\" && exec \"$@\"",
        folder.toString());
  }

  private static int run(String... command) throws IOException, InterruptedException {
    return new ProcessBuilder(command).inheritIO().start().waitFor();
  }
}
