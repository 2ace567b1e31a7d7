package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.generate.Again;
import simbad.blindworld.generate.Order;

/**
 * {@code --at POSES --world DIR}, beside the options by which DIR was drawn: nothing is drawn that
 * was not, but its worlds are read at the poses that stand in folders of their names.
 */
final class ReadAgain {
  static final String AT = "--at";
  static final String WORLD = "--world";

  private ReadAgain() {}

  static boolean isAsked(Options options) {
    return options.text(AT).isPresent() || options.text(WORLD).isPresent();
  }

  static void run(Options options, Order order, PrintStream err)
      throws FormatException, IOException {
    Path poses = Path.of(options.required(AT));
    Again.run(
        order,
        Path.of(options.required(WORLD)),
        poses,
        Path.of(options.required("--out")),
        new Finished(options, Again.count(poses), err));
  }
}
