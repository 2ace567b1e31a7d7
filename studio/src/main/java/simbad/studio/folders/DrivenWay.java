package simbad.studio.folders;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * All places of a trace; what lies in a box of it is given as fine as a screen can show it. A
 * million places are 8 MB. Filled by one thread, then read by any.
 */
final class DrivenWay {
  /** In one answer. */
  static final int MOST = 8000;

  /** So many steps across a box nobody tells apart from more. */
  private static final double STEPS_ACROSS = 2000;

  private static final double FINEST_M = 0.0001;

  private float[] places = new float[1024];
  private int size;

  /**
   * A part of the plane, metres.
   *
   * @param left least x
   * @param top least z
   * @param right greatest x
   * @param bottom greatest z
   */
  record Box(double left, double top, double right, double bottom) {
    /** Where everything lies. */
    static final Box ALL = new Box(-1e9, -1e9, 1e9, 1e9);

    private double acrossM() {
      return Math.max(right - left, bottom - top);
    }
  }

  void add(double xM, double zM) {
    if (2 * size + 2 > places.length) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    places[2 * size] = (float) xM;
    places[2 * size + 1] = (float) zM;
    size++;
  }

  /** How many places it has. */
  int size() {
    return size;
  }

  /**
   * Writes what lies in a box: pieces of places [x, z], to a tenth of a millimetre. Places that lie
   * nearer to the one before than a screen shows are left out, more of them if there are more than
   * {@value #MOST}.
   */
  void write(Box box, ArrayNode pieces) {
    double seenM = Math.min(box.acrossM(), extentM());
    double toleranceM = Math.max(FINEST_M, seenM / STEPS_ACROSS);
    while (walk(box, toleranceM, null) > MOST) {
      toleranceM *= 2;
    }
    walk(box, toleranceM, pieces);
  }

  private double extentM() {
    double least = 0;
    double greatest = 0;
    for (int i = 0; i < 2 * size; i++) {
      least = Math.min(least, places[i]);
      greatest = Math.max(greatest, places[i]);
    }
    return greatest - least;
  }

  /** Goes along the trace and returns how many places are kept; writes them if it is told where. */
  private int walk(Box box, double toleranceM, @Nullable ArrayNode pieces) {
    double toleranceM2 = toleranceM * toleranceM;
    int kept = 0;
    int last = -1;
    boolean open = false;
    // Whether the lines before and after a place are seen.
    boolean after = false;
    @Nullable ArrayNode piece = null;
    for (int i = 0; i < size; i++) {
      boolean before = after;
      after = crosses(box, i);
      if (!before && !after) {
        open = false;
        continue;
      }
      boolean begins = !open;
      open = true;
      if (begins || i + 1 == size || squareM2(i, last) >= toleranceM2) {
        if (pieces != null) {
          piece = begins || piece == null ? pieces.addArray() : piece;
          piece.addArray().add(rounded(places[2 * i])).add(rounded(places[2 * i + 1]));
        }
        last = i;
        kept++;
      }
    }
    return kept;
  }

  /** Whether the line from a place to the next may be seen in a box. */
  private boolean crosses(Box box, int i) {
    int next = Math.min(i + 1, size - 1);
    return Math.min(places[2 * i], places[2 * next]) <= box.right
        && Math.max(places[2 * i], places[2 * next]) >= box.left
        && Math.min(places[2 * i + 1], places[2 * next + 1]) <= box.bottom
        && Math.max(places[2 * i + 1], places[2 * next + 1]) >= box.top;
  }

  private double squareM2(int i, int j) {
    double xM = places[2 * i] - places[2 * j];
    double zM = places[2 * i + 1] - places[2 * j + 1];
    return xM * xM + zM * zM;
  }

  private static double rounded(double metres) {
    return Math.rint(metres * 1e4) / 1e4;
  }
}
