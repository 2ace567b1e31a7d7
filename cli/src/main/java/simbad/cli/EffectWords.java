package simbad.cli;

import java.util.Iterator;
import java.util.List;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;

/** The names of effects, for the shell to complete. */
final class EffectWords implements Iterable<String> {
  @Override
  public Iterator<String> iterator() {
    return Definitions.effects().stream().map(Effect::word).iterator();
  }

  /** What to say of a word that is none of them. */
  static String unknown(String word) {
    List<String> known = Definitions.effects().stream().map(Effect::word).toList();
    return "'"
        + word
        + "' is not the name of an effect; simbad effects lists them"
        + SimilarWords.suggestion(word, known);
  }
}
