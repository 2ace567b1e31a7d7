package simbad.blindworld.motionchange;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.blindworld.motion.MotionChange;

/**
 * A change with the name and the parameters that the truth says of it.
 *
 * @param name from the vocabulary, or this world's own where the vocabulary has none
 * @param parameters in the order in which the truth lists them
 * @param change what it does
 */
public record MotionEffect(String name, Map<String, Object> parameters, MotionChange change) {

  /** Copies the parameters and keeps their order. */
  public MotionEffect {
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
  }
}
