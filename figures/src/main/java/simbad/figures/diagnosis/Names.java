package simbad.figures.diagnosis;

import java.util.Collection;
import java.util.List;
import simbad.definition.Effect;
import simbad.gap.diagnosis.BudgetEntry;

/** Names of effects and of parts of a gap, as pages say them. */
final class Names {
  private Names() {}

  /** A part of the gap, of readings or of motion. */
  static String part(String what) {
    return switch (what) {
      case BudgetEntry.REST -> "not explained";
      case BudgetEntry.FLOOR -> "scatter (floor)";
      default -> what;
    };
  }

  /** Names as a list in words: a, b and c. */
  static String list(Collection<Effect> effects) {
    List<String> words = effects.stream().map(Effect::word).toList();
    if (words.size() < 2) {
      return String.join("", words);
    }
    return String.join(", ", words.subList(0, words.size() - 1))
        + " and "
        + words.get(words.size() - 1);
  }
}
