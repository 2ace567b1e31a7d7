package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Arrays;
import simbad.blindworld.file.FormatException;

/** The command line: {@code generate, benchmark, seal, baseline, score, next}. */
public final class Main {

  private Main() {}

  /** Ends with 0 done, 1 the work failed, 2 bad usage or bad input. */
  public static void main(String[] arguments) {
    System.exit(run(arguments, System.out, System.err));
  }

  /** As {@link #main}, with the streams given and the exit status returned. */
  static int run(String[] arguments, PrintStream out, PrintStream err) {
    String command = arguments.length > 0 ? arguments[0] : "";
    String[] rest =
        arguments.length > 0 ? Arrays.copyOfRange(arguments, 1, arguments.length) : arguments;
    try {
      switch (command) {
        case "generate" -> GenerateCommand.run(rest, err);
        case "score" -> ScoreCommand.run(rest, out);
        case "next" -> NextCommand.run(rest, out);
        case "baseline" -> BaselineCommand.run(rest, err);
        case "seal" -> SealCommand.run(rest);
        case "benchmark" -> BenchmarkCommand.run(rest, out, err);
        default ->
            throw new FormatException(
                "'" + command + "': expected generate, benchmark, seal, baseline, score or next");
      }
      if (out.checkError()) {
        throw new IOException("cannot write to standard output");
      }
      return 0;
    } catch (FormatException e) {
      err.println("blind-world: " + e.getMessage());
      return 2;
    } catch (NoSuchFileException e) {
      err.println("blind-world: " + e.getFile() + ": there is no such file");
      return 2;
    } catch (FileSystemException e) {
      err.println("blind-world: " + e.getMessage());
      return 1;
    } catch (IOException | RuntimeException e) {
      err.println("blind-world: " + e);
      return 1;
    }
  }
}
