package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import simbad.blindworld.baseline.Baseline;
import simbad.blindworld.file.FormatException;

/** {@code baseline --cases DIR --rows DIR --out DIR}. */
final class BaselineCommand {

  private BaselineCommand() {}

  static void run(String[] arguments, PrintStream err) throws FormatException, IOException {
    Options options = new Options(arguments, List.of("--cases", "--rows", "--out"));
    Path cases = Path.of(options.required("--cases"));
    Path rows = options.text("--rows").map(Path::of).orElse(cases);
    for (String fault : Baseline.run(cases, rows, Path.of(options.required("--out")))) {
      err.println("no answer: " + fault);
    }
  }
}
