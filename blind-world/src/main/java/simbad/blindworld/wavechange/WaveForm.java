package simbad.blindworld.wavechange;

import java.util.function.Function;
import java.util.function.Predicate;

/**
 * A change by name, where it can happen, and how it is drawn.
 *
 * @param name from the vocabulary or outside it
 * @param driven true when only to a robot
 * @param applies where it can happen
 * @param draw with parameters drawn by chance
 */
record WaveForm(
    String name, boolean driven, Predicate<Site> applies, Function<Site, WaveEffect> draw) {

  /** One that can happen on a bench and to a robot. */
  WaveForm(String name, Predicate<Site> applies, Function<Site, WaveEffect> draw) {
    this(name, false, applies, draw);
  }

  /** One that can happen everywhere. */
  static WaveForm anywhere(String name, Function<Site, WaveEffect> draw) {
    return new WaveForm(name, site -> true, draw);
  }
}
