package simbad.blindworld.score;

import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.motionchange.MotionVocabulary;

/** The names of both vocabularies, of sensing and of motion. */
public final class Names {

  private Names() {}

  /** True for a name of one of the vocabularies. */
  public static boolean contains(String name) {
    return Vocabulary.contains(name) || MotionVocabulary.contains(name);
  }

  /** True when both are names of one vocabulary and act at the same stage. */
  static boolean isSameStage(String first, String second) {
    return Vocabulary.isSameStage(first, second) || MotionVocabulary.isSameStage(first, second);
  }
}
