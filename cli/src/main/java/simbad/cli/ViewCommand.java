package simbad.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code simbad view}: the window. */
@Command(
    name = "view",
    description = {
      "Open the Simbad window and run a demo.",
      "Default: a robot follows the edge of an obstacle's detection shadow.",
      "The window's menu has all demos."
    },
    footer = {"", "Example: simbad view", "Example: simbad view AvoidersDemo"})
final class ViewCommand extends Subcommand {
  @Parameters(
      paramLabel = "DEMO",
      arity = "0..1",
      description = "The first demo, a name from simbad demo --list. Default: ${DEFAULT-VALUE}.")
  private String name = "AngleDemo";

  @Mixin private DemoRobot robot = new DemoRobot();

  @Override
  protected void run() throws Exception {
    WindowsAllowed.ask();
    DemoWindow.showRunning(
        robot.in(
            DemoArgument.find(name)
                .orElseThrow(() -> wrongUsage("DEMO: " + DemoArgument.unknown(name))),
            this));
  }
}
