package simbad.studio.folders;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.Arrays;

/**
 * Places of a trace, as many as a screen can show: of places that lie nearer together than a
 * tolerance one is kept, and the tolerance is doubled until few enough are left.
 */
final class TracePoints {
  private static final int MOST = 8000;
  private static final double FINEST_M = 0.0005;

  private double[] places = new double[1024];
  private int size;
  private double toleranceM = FINEST_M;
  private long given;

  void add(double xM, double zM) {
    given++;
    if (isFar(xM, zM)) {
      put(xM, zM);
    }
    if (size > MOST) {
      thin();
    }
  }

  private boolean isFar(double xM, double zM) {
    return size == 0
        || Math.hypot(xM - places[2 * size - 2], zM - places[2 * size - 1]) >= toleranceM;
  }

  private void put(double xM, double zM) {
    if (2 * size + 2 > places.length) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    places[2 * size] = xM;
    places[2 * size + 1] = zM;
    size++;
  }

  private void thin() {
    toleranceM *= 2;
    int all = size;
    size = 0;
    for (int i = 0; i < all; i++) {
      double xM = places[2 * i];
      double zM = places[2 * i + 1];
      if (isFar(xM, zM)) {
        put(xM, zM);
      }
    }
  }

  /** How many places were given. */
  long given() {
    return given;
  }

  /** Writes them as [x, z], to a tenth of a millimetre. */
  void write(ArrayNode to) {
    for (int i = 0; i < size; i++) {
      to.addArray().add(rounded(places[2 * i])).add(rounded(places[2 * i + 1]));
    }
  }

  private static double rounded(double metres) {
    return Math.rint(metres * 1e4) / 1e4;
  }
}
