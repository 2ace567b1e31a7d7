package simbad.cli;

import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Stands in the help for what the launcher has done where nothing is built ({@link
 * simbad.cli.machine.OnTheSpot}).
 */
@Command(
    name = "test",
    description = {
      "Build everything and run all checks and tests, as continuous integration does.",
      "With CI=true in the environment a skipped test counts as failed."
    },
    footer = {
      "",
      "Example: simbad test",
      "Example: simbad test -- -pl sonar-model",
    })
final class TestCommand extends Subcommand {
  @Option(names = "--full", description = "Add the long campaigns.")
  @SuppressWarnings("UnusedVariable") // the launcher's
  private boolean full;

  @Parameters(paramLabel = "-- MAVEN_ARGUMENT", description = "More arguments for Maven.")
  @SuppressWarnings("UnusedVariable") // the launcher's
  private List<String> mavenArguments = List.of();

  @Override
  protected void run() {
    throw wrongUsage("only the launcher can run the tests: call ./simbad test");
  }
}
