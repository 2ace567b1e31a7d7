package simbad.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.format.TextFile;

/** {@code --out} of the commands that print one table where they are given no file for it. */
final class TableResult {
  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "A file that does not exist yet. Default: print the table.")
  private @Nullable Path file;

  /**
   * Refuses a file that cannot be, for work that takes a while.
   *
   * @throws IOException if the file exists, or its folder does not
   */
  void check() throws IOException {
    if (file != null) {
      OutputFile.refuseExisting(file);
    }
  }

  /** Prints the table, or writes it and says where. */
  void give(TableDocument table, PrintWriter out) throws IOException {
    if (file == null) {
      out.print(TableFile.text(table));
    } else {
      check();
      TextFile.create(file, TableFile.text(table));
      out.println("written to " + file);
    }
  }
}
