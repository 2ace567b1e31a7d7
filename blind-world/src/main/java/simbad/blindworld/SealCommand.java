package simbad.blindworld;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.generate.ForeignSets;

/** {@code seal --sets DIR --out DIR ...}. */
final class SealCommand {

  private SealCommand() {}

  static void run(String[] arguments) throws FormatException, IOException {
    Options options = new Options(arguments, List.of("--sets", "--out", "--level", "--seed"));
    ForeignSets sets = ForeignSets.in(Path.of(options.required("--sets")));
    sets.seal(
        Path.of(options.required("--out")),
        options.text("--level").orElse(ForeignSets.LEVEL_UNKNOWN),
        options.whole("--seed", 1));
  }
}
