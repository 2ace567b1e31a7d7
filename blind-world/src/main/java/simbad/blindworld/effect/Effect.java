package simbad.blindworld.effect;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.blindworld.world.Change;

/**
 * A change with the name and the parameters that the truth says of it.
 *
 * @param name from the vocabulary, or this world's own where the vocabulary has none
 * @param parameters in the order in which the truth lists them
 * @param change what it does
 */
public record Effect(String name, Map<String, Object> parameters, Change change) {

  /** Copies the parameters and keeps their order. */
  public Effect {
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
  }
}
