package simbad.figures.plot;

import java.awt.Color;

/**
 * Colours for shares from 0 to 1: ColorBrewer's nine-class YlGnBu (Brewer, 2003), straight lines
 * between. It darkens all the way, so that it orders in print and to colour-blind eyes, and 0 is
 * nearly paper.
 */
final class Ramp {
  private static final int[] STOPS = {
    0xFFFFD9, 0xEDF8B1, 0xC7E9B4, 0x7FCDBB, 0x41B6C4, 0x1D91C0, 0x225EA8, 0x253494, 0x081D58
  };

  private Ramp() {}

  static Color colour(double share) {
    double place = share * (STOPS.length - 1);
    int below = Math.min((int) place, STOPS.length - 2);
    double t = place - below;
    Color a = new Color(STOPS[below]);
    Color b = new Color(STOPS[below + 1]);
    return new Color(
        between(a.getRed(), b.getRed(), t),
        between(a.getGreen(), b.getGreen(), t),
        between(a.getBlue(), b.getBlue(), t));
  }

  private static int between(int from, int to, double t) {
    return (int) Math.round(from + t * (to - from));
  }
}
