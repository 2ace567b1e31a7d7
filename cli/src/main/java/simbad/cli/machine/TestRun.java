package simbad.cli.machine;

import java.io.File;
import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * All checks and tests, as Maven runs them.
 *
 * @param full with the long campaigns
 * @param more arguments for Maven
 */
record TestRun(boolean full, List<String> more) {
  /** Two rooms at a time, where neither uses the other. */
  private static final List<String> MAVEN =
      List.of("mvn", "-B", "-ntp", "verify", "-T", "2", "-Dsimbad.display=true");

  private static final List<String> FULL = List.of("-Dsimbad.full=true", "-DexcludedGroups=none");

  /** A virtual screen. */
  private static final List<String> SCREEN =
      List.of("xvfb-run", "-a", "-s", "-screen 0 1280x1024x24");

  /** Copies the list. */
  TestRun {
    more = List.copyOf(more);
  }

  /**
   * Reads the words after {@code simbad test}.
   *
   * @param words of the command line
   * @throws IllegalArgumentException if one of them is no option of it
   */
  static TestRun of(List<String> words) {
    int end = words.contains("--") ? words.indexOf("--") : words.size();
    for (String word : words.subList(0, end)) {
      if (!word.equals("--full")) {
        throw new IllegalArgumentException(
            "test: '" + word + "' is not an option of it (see simbad test --help)");
      }
    }
    List<String> more = words.subList(Math.min(end + 1, words.size()), words.size());
    return new TestRun(end > 0, more);
  }

  /** The command line on a machine. */
  List<String> command(Machine machine) {
    List<String> command = new ArrayList<>();
    if (!hasDisplay(machine)) {
      command.addAll(SCREEN);
    }
    command.addAll(MAVEN);
    if (full) {
      command.addAll(FULL);
    }
    command.addAll(more);
    return command;
  }

  private static boolean hasDisplay(Machine machine) {
    return !machine.environment().getOrDefault("DISPLAY", "").isEmpty();
  }

  /**
   * Runs them, with this process's outputs.
   *
   * @param machine they run on
   * @param begun a moment before
   * @param complaints told each line of what is wrong besides what Maven says
   * @return the exit status: that of Maven, 1 where tests were skipped and {@code CI} is true
   * @throws IOException if Maven cannot be started, or its reports cannot be read
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  int run(Machine machine, Instant begun, Consumer<String> complaints)
      throws IOException, InterruptedException {
    ProcessBuilder builder =
        new ProcessBuilder(command(machine))
            .directory(machine.project().toFile())
            .inheritIO()
            .redirectInput(new File("/dev/null"));
    builder.environment().put("SIMBAD_TESTING", "1");
    builder.environment().put("JAVA_HOME", machine.java().toString());
    if (!hasDisplay(machine)) {
      // Mesa's software renderer: the same pictures with and without a graphics card.
      builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
    }
    int status = Children.run(builder);
    if (status != 0 || !"true".equals(machine.environment().get("CI"))) {
      return status;
    }
    List<String> skipped = SkippedTests.since(machine.project(), begun);
    if (skipped.isEmpty()) {
      return 0;
    }
    complaints.accept("simbad: skipped tests count as failed here:");
    skipped.forEach(test -> complaints.accept("  " + test));
    return 1;
  }
}
