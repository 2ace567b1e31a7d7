package simbad.gap.calibrate.level;

import java.util.Arrays;

/** By how much something moves with some of the values. */
@SuppressWarnings("ArrayRecordComponent") // read only
record Pull(int[] index, double[] value) {
  /** What it moves by where the values do. */
  double dot(double[] values) {
    double sum = 0;
    for (int i = 0; i < index.length; i++) {
      sum += value[i] * values[index[i]];
    }
    return sum;
  }

  /** With one value more. */
  Pull and(int more, double rise) {
    int[] indices = Arrays.copyOf(index, index.length + 1);
    double[] values = Arrays.copyOf(value, value.length + 1);
    indices[index.length] = more;
    values[value.length] = rise;
    return new Pull(indices, values);
  }
}
