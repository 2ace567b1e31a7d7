package simbad.experiments.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code simbad view}: the window. */
@Command(
    name = "view",
    description = "Open the Simbad window; its menu has the other demos.",
    footer = {"", "Example: simbad view AvoidersDemo"})
final class ViewCommand extends Subcommand {
  @Parameters(
      paramLabel = "DEMO",
      arity = "0..1",
      description = "What it shows first, as simbad demo --list has it. Default: ${DEFAULT-VALUE}.")
  private String name = "BaseDemo";

  @Override
  protected void run() throws Exception {
    DemoWindow.show(
        DemoArgument.find(name).orElseThrow(() -> wrongUsage(DemoArgument.unknown(name))));
  }
}
