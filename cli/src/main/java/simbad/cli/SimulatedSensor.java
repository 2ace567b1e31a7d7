package simbad.cli;

import picocli.CommandLine.Option;
import simbad.sonar.model.DetectionRule;

/** When the simulated board's sensor hears, in a command that works without a board as well. */
final class SimulatedSensor {
  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      description =
          "With --auto: the model that decides when the sensor hears: " + RuleArgument.NAMES + ".")
  private String word = "shadow";

  @Option(names = "--seed", paramLabel = "N", description = "With --auto: seed of a noisy sensor.")
  private long seed = 1;

  /** As it was typed. */
  String word() {
    return word;
  }

  long seed() {
    return seed;
  }

  DetectionRule rule(Subcommand command) {
    return RuleArgument.require(word, command);
  }
}
