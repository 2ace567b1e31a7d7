package simbad.blindworld.generate;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.wavechange.WaveVocabulary;

/** Of which kind the worlds are. */
public enum Worlds {
  /** Equations of a threshold and its edge; levels L1 and L2. */
  EQUATIONS("none:0.375,single:0.375,pair:0.125,unknown:0.125"),
  /** Echoes with a wave form, and a receiver; level L2w. */
  WAVE("none:0.325,single:0.475,unknown:0.2");

  private final String mix;

  Worlds(String mix) {
    this.mix = mix;
  }

  /** The mix of kinds when none is asked for. */
  public String mix() {
    return mix;
  }

  /** The vocabulary's names that can be put in, sorted. */
  public List<String> names() {
    return this == WAVE ? WaveVocabulary.names() : Vocabulary.names();
  }

  /** The names of what the vocabulary does not cover, sorted. */
  public List<String> outside() {
    return this == WAVE ? WaveVocabulary.outside() : Vocabulary.outside();
  }

  /** Names out of a list that cannot be put in. */
  public Set<String> unknownAmong(List<String> names) {
    Set<String> strange = new TreeSet<>(names);
    strange.removeAll(names());
    strange.removeAll(outside());
    return strange;
  }
}
