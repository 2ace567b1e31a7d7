package simbad.figures.diagnosis;

import java.util.Collection;
import java.util.List;
import simbad.definition.Effect;

/** Names of effects in a sentence. */
final class Names {
  private Names() {}

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
