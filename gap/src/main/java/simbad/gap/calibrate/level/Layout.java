package simbad.gap.calibrate.level;

import java.util.List;

/** Where each parameter of the level law stands among the values of a fit. Immutable. */
final class Layout {
  /** Of the absorption; before it the spreading. */
  static final int ABSORPTION = 1;

  /** Of the receiver's departures, the first. */
  static final int RECEIVER = 2;

  /** Of the level that all targets have in common. */
  static final int LEVEL = Loss.SIZE;

  private static final int LOBES = LEVEL + 1;

  private final int[] first;
  private final int lobes;

  Layout(List<Believed> targets) {
    first = new int[targets.size()];
    int next = LOBES;
    for (int i = 0; i < first.length; i++) {
      first[i] = next;
      next += targets.get(i).orbits();
    }
    lobes = next;
  }

  /** Of a target's departure from what is believed of it, at an orbit of its bearings. */
  int lobe(int target, int orbit) {
    return first[target] + orbit;
  }

  /** Of the logarithm of the aperture's radius in metres. */
  int aperture() {
    return lobes;
  }

  /** Of the angle between the beam's axis and the heading, radians. */
  int squint() {
    return lobes + 1;
  }

  /** Of the logarithm of the scatter of the excess in decibels. */
  int scatter() {
    return lobes + 2;
  }

  int size() {
    return lobes + 3;
  }
}
