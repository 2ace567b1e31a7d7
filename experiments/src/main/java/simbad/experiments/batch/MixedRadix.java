package simbad.experiments.batch;

import java.math.BigInteger;
import java.util.List;

/**
 * Numbers the combinations of several dimensions, the last of which changes fastest.
 *
 * @param sizes of the dimensions, each at least 0
 */
record MixedRadix(List<Long> sizes) {
  MixedRadix {
    sizes = List.copyOf(sizes);
  }

  /** How many combinations there are, exactly. */
  BigInteger product() {
    return sizes.stream().map(BigInteger::valueOf).reduce(BigInteger.ONE, BigInteger::multiply);
  }

  /** The number in each dimension of one combination. */
  long[] digits(long number) {
    long[] digits = new long[sizes.size()];
    long rest = number;
    for (int i = digits.length - 1; i >= 0; i--) {
      digits[i] = rest % sizes.get(i);
      rest /= sizes.get(i);
    }
    return digits;
  }
}
