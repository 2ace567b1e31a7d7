package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Slices the windows of half a second into quarters along each axis, the worst first. */
final class MotionPlaces {
  private static final int SLICES = 4;
  private static final int LEAST_ROWS = 5;

  private MotionPlaces() {}

  static List<MotionPlace> of(Evidence evidence, double[][] nominal, double[][] diagnosed) {
    double[] before = sizes(nominal, nominal);
    double[] after = sizes(diagnosed, nominal);
    List<MotionPlace> places = new ArrayList<>();
    ToDoubleFunction<Window> speed = w -> w.way().alongM() / w.horizonS();
    ToDoubleFunction<Window> turn = w -> wrapped(w.way().turnRad()) / w.horizonS();
    places.addAll(slice("speed_m_s", speed, evidence, before, after));
    places.addAll(slice("turn_rad_s", turn, evidence, before, after));
    places.addAll(slice("t_s", Window::startS, evidence, before, after));
    places.addAll(slice("heading_deg", w -> degrees(w.headingRad()), evidence, before, after));
    places.addAll(slice("x_m", Window::xM, evidence, before, after));
    places.addAll(slice("z_m", w -> -w.yM(), evidence, before, after));
    places.sort(Comparator.comparingDouble((MotionPlace place) -> -place.share()));
    return places;
  }

  private static double degrees(double rad) {
    return Math.toDegrees(wrapped(rad));
  }

  /** Half a turn at most either way: a tracker's heading may jump by a whole one. */
  private static double wrapped(double rad) {
    return Math.IEEEremainder(rad, 2 * Math.PI);
  }

  /** Absolute errors of all components, each in units of its nominal mean. */
  private static double[] sizes(double[][] residuals, double[][] nominal) {
    double[] sizes = new double[residuals.length];
    for (int c = 0; c < 3; c++) {
      double mean = 0;
      for (double[] residual : nominal) {
        mean += Math.abs(residual[c]) / nominal.length;
      }
      for (int i = 0; i < sizes.length && mean > 0; i++) {
        sizes[i] += Math.abs(residuals[i][c]) / mean / 3;
      }
    }
    return sizes;
  }

  private static List<MotionPlace> slice(
      String axis,
      ToDoubleFunction<Window> value,
      Evidence evidence,
      double[] before,
      double[] after) {
    List<MotionPlace> places = new ArrayList<>();
    double[] values = new double[evidence.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = value.applyAsDouble(evidence.window(i));
    }
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    double total = Arrays.stream(before).sum();
    for (int s = 0; s < SLICES && sorted.length > SLICES; s++) {
      double low = sorted[s * (sorted.length - 1) / SLICES];
      double high = sorted[(s + 1) * (sorted.length - 1) / SLICES];
      double sumBefore = 0;
      double sumAfter = 0;
      int rows = 0;
      for (int i = 0; i < values.length; i++) {
        if (values[i] >= low && (values[i] < high || s == SLICES - 1)) {
          sumBefore += before[i];
          sumAfter += after[i];
          rows++;
        }
      }
      if (rows >= LEAST_ROWS && total > 0) {
        places.add(
            new MotionPlace(
                axis, low, high, rows, sumBefore / total, sumBefore / rows, sumAfter / rows));
      }
    }
    return places;
  }
}
