package simbad.blindworld.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.check.Checks;

/**
 * The stretches of a track that are forecast: 0.5, 2 and 5 s from every half second at which it is
 * known, to where it is known again. In the order of runs, times and horizons.
 */
public final class Windows {

  /** How long they are, in seconds. */
  static final double[] HORIZONS_S = {0.5, 2, 5};

  /** Along, across and turn. */
  public static final int COMPONENTS = 3;

  private final Outing outing;
  private final List<Window> windows;

  /**
   * One window.
   *
   * @param run index of the run
   * @param beginS the half second at which it begins
   * @param horizon index of the horizon
   * @param from index of the frame at its beginning
   * @param to index of the frame at its end
   */
  public record Window(int run, double beginS, int horizon, int from, int to) {
    /** Refuses what is no such thing. */
    public Window {
      Checks.finite("begin", beginS);
    }

    /** How long it is. */
    public double horizonS() {
      return HORIZONS_S[horizon];
    }
  }

  private Windows(Outing outing, List<Window> windows) {
    this.outing = outing;
    this.windows = List.copyOf(windows);
  }

  /** The windows of an outing. */
  public static Windows of(Outing outing) {
    List<Window> windows = new ArrayList<>();
    for (int r = 0; r < outing.runs().size(); r++) {
      Outing.Run run = outing.runs().get(r);
      if (run.frames() > 0) {
        int first = (int) Math.ceil((run.frameS(0) - Outing.NEAR_S) / Outing.BEAT_S);
        int last = (int) Math.floor(run.frameS(run.frames() - 1) / Outing.BEAT_S + 0.1);
        for (int beat = first; beat <= last; beat++) {
          addAll(windows, run, r, beat * Outing.BEAT_S);
        }
      }
    }
    return new Windows(outing, windows);
  }

  private static void addAll(List<Window> windows, Outing.Run run, int r, double atS) {
    int from = frameAt(run, atS);
    for (int h = 0; from >= 0 && h < HORIZONS_S.length; h++) {
      int to = frameAt(run, atS + HORIZONS_S[h]);
      if (to >= 0) {
        windows.add(new Window(r, atS, h, from, to));
      }
    }
  }

  /** The nearest frame that is near enough to a time; -1 without one. */
  private static int frameAt(Outing.Run run, double atS) {
    int low = 0;
    int high = run.frames() - 1;
    while (low < high) {
      int middle = (low + high) / 2;
      if (run.frameS(middle) < atS) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    boolean before = low > 0 && atS - run.frameS(low - 1) < Math.abs(run.frameS(low) - atS);
    int nearest = before ? low - 1 : low;
    return Math.abs(run.frameS(nearest) - atS) <= Outing.NEAR_S ? nearest : -1;
  }

  /** How many there are. */
  public int size() {
    return windows.size();
  }

  /** One of them. */
  public Window at(int index) {
    return windows.get(index);
  }

  /** The name of a window's run. */
  public String run(int index) {
    return outing.runs().get(windows.get(index).run()).name();
  }

  /**
   * What a track shows of them, by window: along and across in metres, in the frame of the pose at
   * the beginning, across to the left; and the turn in degrees, counter-clockwise.
   */
  public double[][] displacements(Track track) {
    double[][] all = new double[size()][];
    for (int i = 0; i < all.length; i++) {
      all[i] = displacement(track, windows.get(i));
    }
    return all;
  }

  private static double[] displacement(Track track, Window window) {
    double heading = track.headingRad(window.run, window.from);
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    double dx = track.xM(window.run, window.to) - track.xM(window.run, window.from);
    double dz = track.zM(window.run, window.to) - track.zM(window.run, window.from);
    double turn = track.headingRad(window.run, window.to) - heading;
    return new double[] {dx * cos - dz * sin, -dx * sin - dz * cos, Math.toDegrees(turn)};
  }
}
