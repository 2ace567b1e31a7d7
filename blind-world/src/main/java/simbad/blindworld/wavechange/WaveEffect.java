package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import simbad.blindworld.wave.Alteration;

/**
 * A change with what the truth says of it.
 *
 * @param name from the vocabulary, or this world's own where the vocabulary has none
 * @param parameters by name, sorted
 * @param alteration what it does
 * @param accept the sets of names by which physics allows to call it
 * @param also sets of names that do nearly the same and are not right
 */
public record WaveEffect(
    String name,
    Map<String, Object> parameters,
    Alteration alteration,
    List<Set<String>> accept,
    List<Set<String>> also) {

  /** Copies the collections; parameters are sorted, for maps have no order of their own. */
  public WaveEffect {
    parameters = Collections.unmodifiableMap(new TreeMap<>(parameters));
    accept = List.copyOf(accept);
    also = List.copyOf(also);
  }

  /** A change that is called by its name only. */
  static WaveEffect of(String name, Map<String, Object> parameters, Alteration alteration) {
    return new WaveEffect(name, parameters, alteration, List.of(Set.of(name)), List.of());
  }

  /** The same, which may be called otherwise as well. */
  WaveEffect accepting(List<Set<String>> more) {
    List<Set<String>> all = new ArrayList<>(accept);
    all.addAll(more);
    return new WaveEffect(name, parameters, alteration, all, also);
  }

  /** The same, with names that come near. */
  WaveEffect near(List<Set<String>> others) {
    List<Set<String>> all = new ArrayList<>(also);
    all.addAll(others);
    return new WaveEffect(name, parameters, alteration, accept, all);
  }
}
