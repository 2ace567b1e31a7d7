package simbad.gap;

import java.util.Map;

/**
 * Something that has no name among the effects.
 *
 * @param probability that it is at work, in [0, 1]
 * @param signs by which it is so probable, by name
 * @param what it does, in words; empty where that is not known
 */
record Unnamed(double probability, Map<String, Double> signs, String what) {
  /** What the verdict says of it, where it is as likely as not. */
  String reason() {
    return what.isEmpty() ? "" : what + ", and no effect of the list does that";
  }
}
