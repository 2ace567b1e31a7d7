package simbad.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code simbad view}: the window. */
@Command(
    name = "view",
    description = {
      "Open the Simbad window with a demo that runs: a robot whose sonars follow the edge of an"
          + " obstacle's detection shadow, unless another one is named.",
      "Its menu has all demos."
    },
    footer = {"", "Example: simbad view", "Example: simbad view AvoidersDemo"})
final class ViewCommand extends Subcommand {
  @Parameters(
      paramLabel = "DEMO",
      arity = "0..1",
      description = "What it shows first, as simbad demo --list has it. Default: ${DEFAULT-VALUE}.")
  private String name = "AngleDemo";

  @Override
  protected void run() throws Exception {
    WindowsAllowed.ask();
    DemoWindow.showRunning(
        DemoArgument.find(name).orElseThrow(() -> wrongUsage(DemoArgument.unknown(name))));
  }
}
