package simbad.cli.machine;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What the launcher compiles and starts where the program is not built: {@code doctor}, {@code
 * test}, and what is needed before a build.
 */
public final class OnTheSpot {
  private static final int FAILED = 1;
  private static final int WRONG_USAGE = 2;

  private OnTheSpot() {}

  /**
   * Does one of them and exits.
   *
   * @param words the command line
   */
  public static void main(String... words) throws InterruptedException {
    Optional.ofNullable(System.getProperty("simbad.spot"))
        .map(Path::of)
        .ifPresent(OnTheSpot::deleteAtEnd);
    int status;
    try {
      status = run(Launcher.ofThisProcess().orElseThrow(), Clock.systemUTC(), List.of(words));
    } catch (SaidAlreadyException e) {
      status = FAILED;
    } catch (IOException e) {
      System.err.println("simbad: " + words[0] + ": " + e.getMessage());
      status = FAILED;
    } catch (IllegalArgumentException e) {
      System.err.println("simbad: " + e.getMessage());
      status = WRONG_USAGE;
    }
    System.exit(status);
  }

  /** The folder that these classes were compiled to; nothing else lies in it. */
  private static void deleteAtEnd(Path folder) {
    try (Stream<Path> entries = Files.walk(folder)) {
      // What is named last goes first.
      entries.forEach(entry -> entry.toFile().deleteOnExit());
    } catch (IOException e) {
      System.err.println("simbad: " + folder + " is left behind: " + e.getMessage());
    }
  }

  private static int run(Launcher launcher, Clock clock, List<String> words)
      throws IOException, InterruptedException {
    Machine machine = Machine.here(launcher.project());
    if (words.get(0).equals("doctor")) {
      return Doctor.examine(machine, System.out::println) ? 0 : FAILED;
    }
    if (words.get(0).equals("need")) {
      Launcher.need(Purpose.of(words.get(1)));
      return 0;
    }
    TestRun tests = TestRun.of(words.subList(1, words.size()));
    Launcher.need(Purpose.TEST);
    return tests.run(machine, clock.instant(), System.err::println);
  }
}
