package simbad.cli;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.demo.Demo;
import simbad.demo.DemoManager;

/** {@code simbad demo}: a demo in the window, or without one. */
@Command(
    name = "demo",
    description = {
      "Run a demo in the window.",
      "With --headless it runs without a window, as fast as possible, and prints where "
          + "all agents are at the end.",
      "Demos use no random numbers: the same number of steps always gives the same places."
    },
    footer = {
      "",
      "Example: simbad demo --list",
      "Example: simbad demo PickCherriesDemo --headless --steps 500",
      "Example: simbad demo angle --robot diagnosed:data/robots/create-1 --headless"
    })
final class DemoCommand extends Subcommand {
  private static final int DEFAULT_STEPS = 2000;

  @Parameters(
      paramLabel = "NAME",
      arity = "0..1",
      description =
          "A name from --list; small letters, and a name without Demo, will do. Or an "
              + "obstacle: its name, folder or table.")
  private String name = "";

  @Option(names = "--list", description = "Print the names of all demos.")
  private boolean list;

  @Option(names = "--headless", description = "Without a window. No display is needed.")
  private boolean headless;

  @Option(
      names = "--steps",
      paramLabel = "N",
      description = "With --headless: steps of 0.05 s. Default: " + DEFAULT_STEPS + ".")
  private @Nullable Integer steps;

  @Mixin private DemoRobot robot = new DemoRobot();

  @Override
  protected void run() throws Exception {
    if (list) {
      if (!name.isEmpty() || headless || steps != null || robot.isNamed()) {
        throw wrongUsage("--list: expected nothing beside it");
      }
      DemoManager.names().forEach(out()::println);
      return;
    }
    if (name.isEmpty()) {
      throw wrongUsage("expected the NAME of a demo: one of " + String.join(", ", names()));
    }
    if (steps != null && (steps < 1 || !headless)) {
      throw wrongUsage(
          headless
              ? "--steps: " + steps + " is not in [1, 2147483647]"
              : "--steps needs --headless");
    }
    if (!headless) {
      WindowsAllowed.ask();
    }
    Demo demo =
        robot.in(
            DemoArgument.find(name)
                .orElseThrow(() -> wrongUsage("NAME: " + DemoArgument.unknown(name))),
            this);
    if (headless) {
      runHeadless(demo, steps == null ? DEFAULT_STEPS : steps);
    } else {
      DemoWindow.show(demo);
    }
  }

  private static List<String> names() {
    return DemoManager.names();
  }

  private void runHeadless(Demo demo, int count) throws IOException {
    HeadlessDemo run = new HeadlessDemo(demo);
    long begun = System.nanoTime();
    try (Progress progress = Progress.of("stepping", count)) {
      for (int i = 0; i < count; i++) {
        run.step();
        progress.step();
      }
    }
    run.print(out(), (System.nanoTime() - begun) / 1e9);
  }
}
