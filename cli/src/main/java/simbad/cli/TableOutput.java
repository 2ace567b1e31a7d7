package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Option;

/** {@code --out} of the commands that write one table. */
final class TableOutput {
  @Option(
      names = "--out",
      paramLabel = "FILE",
      required = true,
      description = "A file that does not exist yet.")
  private Path file = Path.of("");

  /**
   * Returns the file.
   *
   * @throws IOException if it exists
   */
  Path file() throws IOException {
    OutputFile.refuseExisting(file);
    return file;
  }
}
