package simbad.blindworld.generate;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.motionchange.MotionVocabulary;
import simbad.blindworld.wavechange.WaveVocabulary;

/** Of which kind the worlds are. */
public enum Worlds {
  /** Equations of a threshold and its edge; levels L1 and L2. */
  EQUATIONS("none:0.375,single:0.375,pair:0.125,unknown:0.125"),
  /** Echoes with a wave form, and a receiver; level L2w. */
  WAVE("none:0.325,single:0.475,unknown:0.2"),
  /** Robots that drive before a tracker; levels M1 and, with a reference, M2. */
  MOTION("none:0.375,single:0.375,pair:0.125,unknown:0.125");

  private final String mix;

  Worlds(String mix) {
    this.mix = mix;
  }

  /** The mix of kinds when none is asked for. */
  public String mix() {
    return mix;
  }

  /** The vocabulary's names that are put in where nobody asks for any, sorted. */
  public List<String> names() {
    return switch (this) {
      case EQUATIONS -> Vocabulary.names();
      case WAVE -> WaveVocabulary.names();
      case MOTION -> MotionVocabulary.names();
    };
  }

  /** The same, and then the names that are put in only where somebody asks for them. */
  public List<String> all() {
    List<String> further = this == EQUATIONS ? Vocabulary.further() : List.of();
    return Stream.concat(names().stream(), further.stream()).toList();
  }

  /** The names of what the vocabulary does not cover, sorted. */
  public List<String> outside() {
    return switch (this) {
      case EQUATIONS -> Vocabulary.outside();
      case WAVE -> WaveVocabulary.outside();
      case MOTION -> MotionVocabulary.outside();
    };
  }

  /** True for a name of the vocabulary, whether or not it can be put in here. */
  public boolean contains(String name) {
    return this == MOTION ? MotionVocabulary.contains(name) : Vocabulary.contains(name);
  }

  /** True when the two act at different stages, so that a pair of them is a fair question. */
  public boolean isFairPair(String first, String second) {
    return this == MOTION
        ? MotionVocabulary.isFairPair(first, second)
        : Vocabulary.isFairPair(first, second);
  }

  /** Names out of a list that cannot be put in. */
  public Set<String> unknownAmong(List<String> names) {
    Set<String> strange = new TreeSet<>(names);
    strange.removeAll(all());
    strange.removeAll(outside());
    return strange;
  }
}
