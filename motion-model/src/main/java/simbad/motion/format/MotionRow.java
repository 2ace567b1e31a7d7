package simbad.motion.format;

import java.util.List;

/**
 * A row of a file.
 *
 * @param <T> what it says
 * @param row counted from 0 below the header
 * @param value what it says
 */
public record MotionRow<T>(int row, T value) {
  static <T> List<T> values(List<MotionRow<T>> rows) {
    return rows.stream().map(MotionRow::value).toList();
  }
}
