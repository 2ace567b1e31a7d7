package simbad.blindworld.motionchange;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import simbad.blindworld.motion.MotionChange;

/**
 * One way in which an effect shows itself.
 *
 * @param effect the effect's name
 * @param label which form of it
 * @param applies where it can be put in
 * @param draw parameters and what they do, drawn by chance
 */
record MotionForm(
    String effect, String label, Predicate<MotionSite> applies, Function<MotionSite, Drawn> draw) {

  /** What was drawn: parameters for the truth, and the change that they make. */
  record Drawn(Map<String, Object> parameters, MotionChange change) {}

  static MotionForm anywhere(String effect, String label, Function<MotionSite, Drawn> draw) {
    return new MotionForm(effect, label, site -> true, draw);
  }

  /** A form of a robot whose commands are its wheels' speeds. */
  static MotionForm differential(String effect, String label, Function<MotionSite, Drawn> draw) {
    return new MotionForm(effect, label, site -> site.robot().differential(), draw);
  }

  /** A form of a robot that goes back now and then. */
  static MotionForm reversing(String effect, String label, Function<MotionSite, Drawn> draw) {
    return new MotionForm(effect, label, MotionSite::reverses, draw);
  }

  MotionEffect in(MotionSite site) {
    Drawn drawn = draw.apply(site);
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("form", label);
    parameters.putAll(new TreeMap<>(drawn.parameters()));
    return new MotionEffect(effect, parameters, drawn.change());
  }
}
