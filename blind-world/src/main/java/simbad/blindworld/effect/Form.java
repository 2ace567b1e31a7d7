package simbad.blindworld.effect;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import simbad.blindworld.world.Change;

/**
 * One way in which an effect shows itself.
 *
 * @param effect the effect's name
 * @param label which form of it
 * @param applies where it can be put in
 * @param draw parameters and what they do, drawn by chance
 */
record Form(
    String effect,
    String label,
    Predicate<Circumstances> applies,
    Function<Circumstances, Drawn> draw) {

  /** What was drawn: parameters for the truth, and the change that they make. */
  record Drawn(Map<String, Object> parameters, Change change) {}

  /** A form that applies everywhere. */
  static Form anywhere(String effect, String label, Function<Circumstances, Drawn> draw) {
    return new Form(effect, label, c -> true, draw);
  }

  /** A form that needs a robot that drives. */
  static Form driven(String effect, String label, Function<Circumstances, Drawn> draw) {
    return new Form(effect, label, Circumstances::driven, draw);
  }

  /** The effect with parameters drawn for these circumstances. */
  Effect in(Circumstances circumstances) {
    Drawn drawn = draw.apply(circumstances);
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("form", label);
    parameters.putAll(new TreeMap<>(drawn.parameters()));
    return new Effect(effect, parameters, drawn.change());
  }
}
