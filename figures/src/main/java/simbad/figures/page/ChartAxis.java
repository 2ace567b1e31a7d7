package simbad.figures.page;

import java.util.List;

/** Where values lie along a side of a graph. */
public interface ChartAxis {
  /** Returns where a value lies, 0 at the begin and 1 at the end. */
  double share(double value);

  /** Returns the values that have a label, from begin to end. */
  List<Double> ticks();

  /** Returns the label of a tick. */
  String label(double tick);
}
