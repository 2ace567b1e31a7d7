package simbad.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.figures.plot.SeriesRole;
import simbad.figures.report.SensorRoles;

/**
 * Which colour and pattern each curve of a tuning plot has. A colour is never of two sensors, and a
 * sensor's first curve has the colour that it has in every other picture. Where there are colours
 * enough, each curve has its own; else a sensor's curves differ in their patterns.
 */
final class TuningLooks {
  private static final List<SeriesRole> ROLES =
      List.of(
          SeriesRole.SHADOW,
          SeriesRole.OVERLAP,
          SeriesRole.NOISY,
          SeriesRole.RAY,
          SeriesRole.OTHER,
          SeriesRole.ORIGINAL);

  /** More sensors than this have no colours of their own. */
  static final int MOST_SENSORS = ROLES.size();

  private final Map<String, List<SeriesRole>> roles = new LinkedHashMap<>();
  private final boolean isShared;

  /**
   * Deals the colours out.
   *
   * @param curves how many each sensor has; at most {@link #MOST_SENSORS} sensors
   */
  TuningLooks(Map<String, Integer> curves) {
    List<SeriesRole> free = new ArrayList<>(ROLES);
    curves.keySet().forEach(sensor -> roles.put(sensor, new ArrayList<>()));
    roles.forEach(
        (sensor, own) -> SensorRoles.usual(sensor).filter(free::remove).ifPresent(own::add));
    roles.values().stream().filter(List::isEmpty).forEach(own -> own.add(free.remove(0)));
    int extra = curves.values().stream().mapToInt(count -> count - 1).sum();
    isShared = extra > free.size();
    if (!isShared) {
      curves.forEach((sensor, count) -> deal(free, role(sensor), count - 1));
    }
  }

  private void deal(List<SeriesRole> free, List<SeriesRole> own, int count) {
    for (int i = 0; i < count; i++) {
      own.add(free.remove(0));
    }
  }

  private List<SeriesRole> role(String sensor) {
    return roles.getOrDefault(sensor, List.of());
  }

  /** Returns the role whose colour a sensor's curve has. */
  SeriesRole role(String sensor, int curve) {
    List<SeriesRole> own = role(sensor);
    return own.get(Math.min(curve, own.size() - 1));
  }

  /** Returns a curve's pattern: 0 where its colour is its own. */
  int pattern(String sensor, int curve) {
    return isShared ? curve + 1 : 0;
  }
}
