package simbad.cli;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.sonar.model.DetectionRule;

/** When the simulated board's sensor hears, in a command that works without a board as well. */
final class SimulatedSensor {
  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      description =
          "With --auto: the model that decides when the sensor hears: " + RuleArgument.NAMES + ".")
  private @Nullable String word;

  @Option(names = "--seed", paramLabel = "N", description = "With --auto: seed of a noisy sensor.")
  private @Nullable Long seed;

  /** As it was typed. */
  String word() {
    return word == null ? "shadow" : word;
  }

  long seed() {
    return seed == null ? 1 : seed;
  }

  DetectionRule rule(Subcommand command) {
    return RuleArgument.require(word(), command);
  }

  /** Refuses a real sensor that is told what to hear. */
  void requireSimulated(boolean simulated, Subcommand command) {
    if (!simulated && (word != null || seed != null)) {
      throw command.wrongUsage(
          (word == null ? "--seed: " + seed : "--sensor: '" + word + "'")
              + " is for the simulated sensor; expected --auto with it");
    }
  }
}
