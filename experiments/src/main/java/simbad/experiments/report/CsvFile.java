package simbad.experiments.report;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.function.Consumer;
import simbad.sonar.format.TextFile;

/** Csv files that are written as a whole, with the line ends of Unix. */
public final class CsvFile {
  private CsvFile() {}

  /**
   * Writes a file, over one that may be there.
   *
   * @param file its directory must exist
   * @param rows adds the rows, the header first
   * @throws IOException naming the file, if it cannot be written; it is then as it was
   */
  public static void write(Path file, Consumer<CsvWriter> rows) throws IOException {
    StringWriter text = new StringWriter();
    try (CsvWriter csv = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(text)) {
      rows.accept(csv);
    }
    TextFile.write(file, text.toString());
  }
}
