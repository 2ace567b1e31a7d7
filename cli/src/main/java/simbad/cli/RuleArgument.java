package simbad.cli;

import java.util.Locale;
import java.util.Optional;
import simbad.sonar.model.DetectionRule;

/** When the simulated board's sensor hears, as named on the command line. */
final class RuleArgument {
  static final String NAMES = "shadow, original, overlap, noisy, level, level-noisy";

  private RuleArgument() {}

  static Optional<DetectionRule> parse(String word) {
    for (DetectionRule rule : DetectionRule.values()) {
      if (rule.name().toLowerCase(Locale.ROOT).replace('_', '-').equals(word)) {
        return Optional.of(rule);
      }
    }
    return Optional.empty();
  }

  /** The same for the option --sensor of a command, which refuses other words. */
  static DetectionRule require(String word, Subcommand command) {
    return parse(word)
        .orElseThrow(() -> command.wrongUsage("--sensor: '" + word + "' is none of " + NAMES));
  }
}
