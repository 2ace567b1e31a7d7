package simbad.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.program.Pictures;
import simbad.experiments.program.ProgramException;
import simbad.experiments.program.ProgramFile;
import simbad.experiments.program.ProgramRun;
import simbad.experiments.program.RunPlan;
import simbad.experiments.program.WindowRun;
import simbad.sim.Compatibility;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** {@code simbad program}: other people's programs, as they are. */
@Command(
    name = "program",
    description = {
      "Run a program that was written for Simbad, unchanged and without a window.",
      "Each world that it opens with new Simbad(...) is stepped at full speed.",
      "--trace FILE writes where all agents were after each step. (Only in this "
          + "command --trace takes a file.)"
    },
    footer = {
      "",
      "Example: simbad program my-program --steps 200",
      "Example: simbad program my-program --steps 200 --trace poses.csv --compare released-1.4"
    })
final class ProgramCommand extends Subcommand {
  private static final String EVERY = "every:";
  private static final long DEFAULT_STEPS = 2000;

  @Parameters(
      paramLabel = "PROGRAM",
      description = "A jar, a folder of classes, or a folder of Java sources in any encoding.")
  private Path program = Path.of(".");

  @Parameters(
      index = "1..*",
      arity = "0..*",
      paramLabel = "ARGUMENT",
      description = "Arguments for the program's main.")
  private List<String> arguments = List.of();

  @Option(
      names = "--class-path",
      paramLabel = "PATHS",
      description = "Other people's jars and folders of classes or sources, separated by a colon.")
  private String classPath = "";

  @Option(
      names = "--main",
      paramLabel = "CLASS",
      description =
          "The class to start. Default: the only class with a main, or the only environment.")
  private @Nullable String main;

  @Option(
      names = "--steps",
      paramLabel = "N",
      description = "Steps of each world. Default: " + DEFAULT_STEPS + ".")
  private @Nullable Long steps;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "Seed of all random numbers, Math.random() included. Default: ${DEFAULT-VALUE}.")
  private long seed = 1;

  @Option(
      names = "--compat",
      paramLabel = "SWITCHES",
      description =
          "Behave as a version of the original did: 1.7, released-1.4, upstream, or the "
              + "names of switches.")
  private String compat = "";

  @Option(
      names = "--compare",
      paramLabel = "SWITCHES",
      description = "Run it a second time with these, and say at which step the two runs part.")
  private @Nullable String compare;

  @Option(
      names = "--picture",
      paramLabel = "every:N",
      description = "Every N steps write a picture of the first world from above into --pictures.")
  private @Nullable String picture;

  @Option(
      names = "--pictures",
      paramLabel = "DIR",
      description = "A folder that does not exist yet. Default: program-pictures.")
  private @Nullable Path pictures;

  @Option(
      names = "--window",
      description =
          "Run in the window, until it is closed. Only --compat, --seed, --main and "
              + "--class-path go with it.")
  private boolean window;

  private @Nullable Path trace;

  /** Set by what parses {@code --trace}, which without a file is another option. */
  void setTrace(Path file) {
    trace = file;
  }

  @Override
  protected void run() throws Exception {
    checkSwitches("--compat", compat);
    if (steps != null && steps < 1) {
      throw wrongUsage("--steps: " + steps + " is not in [1, infinity)");
    }
    refuseUnread();
    if (window) {
      WindowsAllowed.ask();
    }
    ProgramFile file = ProgramFile.read(program, libraries(), err()::println);
    file.notes().forEach(out()::println);
    RunPlan plan = plan(file);
    if (window) {
      WindowRun.run(plan);
      return;
    }
    ProgramRun run = withPictures(plan);
    if (trace != null) {
      TextFile.write(trace, run.trace().csv());
    }
    say(run);
    compare(plan, run);
  }

  private void refuseUnread() {
    if (pictures != null && picture == null) {
      throw wrongUsage("--pictures: '" + pictures + "' needs --picture every:N");
    }
    if (window && Stream.of(steps, compare, picture, trace).anyMatch(Objects::nonNull)) {
      throw wrongUsage(
          "--window: expected only --compat, --seed, --main and --class-path beside it");
    }
  }

  private ProgramRun withPictures(RunPlan plan) throws IOException, ProgramException {
    if (picture == null) {
      return ProgramRun.run(plan, null);
    }
    long every = every(picture);
    Path folder = pictures == null ? Path.of("program-pictures") : pictures;
    try (StagedDirectory staged = StagedDirectory.beside(folder)) {
      Pictures taken = new Pictures(staged.path(), every);
      ProgramRun run = ProgramRun.run(plan, taken);
      staged.publish();
      out().println(taken.count() + " pictures written to " + folder);
      return run;
    }
  }

  private long every(String text) {
    try {
      long every = text.startsWith(EVERY) ? Long.parseLong(text.substring(EVERY.length())) : 0;
      if (every > 0) {
        return every;
      }
    } catch (NumberFormatException e) {
      // Said below.
    }
    throw wrongUsage("--picture: '" + text + "' is not every:N with N at least 1");
  }

  private List<Path> libraries() {
    return Arrays.stream(classPath.split(File.pathSeparator, -1))
        .filter(entry -> !entry.isEmpty())
        .map(Path::of)
        .toList();
  }

  private void checkSwitches(String option, String switches) {
    for (String name : switches.split(",", -1)) {
      try {
        Compatibility.parse(name);
      } catch (IllegalArgumentException e) {
        throw wrongUsage(
            option + ": '" + name + "' is no switch; docs/compatibility.md lists them");
      }
    }
  }

  private RunPlan plan(ProgramFile file) throws DataFormatException {
    if (compare != null) {
      checkSwitches("--compare", compare);
    }
    boolean traced = trace != null || compare != null;
    long count = steps == null ? DEFAULT_STEPS : steps;
    return file.plan(main, arguments, new RunPlan.Settings(compat, count, seed, traced));
  }

  private void say(ProgramRun run) {
    out()
        .printf(
            Locale.ROOT,
            "%d steps, %d world%s, %d agents%n",
            run.steps(),
            run.worlds(),
            run.worlds() == 1 ? "" : "s",
            run.agents());
    Set<Compatibility> on = Compatibility.parse(compat);
    List<String> touched = new ArrayList<>();
    for (Compatibility habit : run.touched()) {
      touched.add(habit.switchName() + (on.contains(habit) ? " (on)" : " (off)"));
    }
    out()
        .println(
            touched.isEmpty()
                ? "no compatibility switch would have changed this run"
                : touched.stream()
                    .collect(
                        Collectors.joining(", ", "depended on: ", "; see docs/compatibility.md")));
  }

  private void compare(RunPlan plan, ProgramRun run) throws ProgramException {
    if (compare != null) {
      ProgramRun other = ProgramRun.run(plan.with(compare), null);
      String name = compat.isEmpty() ? "the default" : compat;
      out().println(name + " and " + compare + ": " + run.trace().comparedTo(other.trace()));
    }
  }
}
