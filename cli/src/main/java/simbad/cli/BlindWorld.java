package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simbad.sonar.format.DataFormatException;

/**
 * The blind world's program, each call a process of its own.
 *
 * @param program what is started
 */
record BlindWorld(JavaProgram program) {
  private static final Duration FOR_EVER = Duration.ofDays(365);
  private static final String NAME = "blind-world: ";

  /**
   * Runs it to its end.
   *
   * @param arguments of the call
   * @param out where its results go
   * @param heard told each line of its standard error that is no complaint
   * @throws DataFormatException when it says that the input is bad
   * @throws IOException when it fails otherwise
   */
  void run(List<String> arguments, Optional<Path> out, Consumer<String> heard)
      throws IOException, DataFormatException, InterruptedException {
    List<String> complaints = Collections.synchronizedList(new ArrayList<>());
    Consumer<String> listener =
        line -> {
          if (line.startsWith(NAME)) {
            complaints.add(line.substring(NAME.length()));
          } else {
            heard.accept(line);
          }
        };
    try (ChildProcess child =
        ChildProcess.start(program.with(arguments), Path.of(""), out, listener)) {
      int status = child.await(FOR_EVER).orElse(ExitStatus.FAILED);
      String complaint = String.join(" ", complaints);
      if (status == ExitStatus.BAD_INPUT) {
        throw DataFormatException.inArgument("blind-world", complaint);
      }
      if (status != ExitStatus.DONE) {
        throw new IOException("blind-world ended with status " + status + ": " + complaint);
      }
    }
  }
}
