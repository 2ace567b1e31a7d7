package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigInteger;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class MixedRadixTest {
  @Property(seed = "20261121")
  void digits_countLikeADial(
      @ForAll @IntRange(min = 1, max = 9) int slow,
      @ForAll @IntRange(min = 1, max = 9) int middle,
      @ForAll @IntRange(min = 1, max = 9) int fast) {
    MixedRadix radix = new MixedRadix(List.of((long) slow, (long) middle, (long) fast));
    assertEquals(slow * middle * fast, radix.product().intValueExact());
    int number = 0;
    for (int i = 0; i < slow; i++) {
      for (int j = 0; j < middle; j++) {
        for (int k = 0; k < fast; k++) {
          assertArrayEquals(new long[] {i, j, k}, radix.digits(number++));
        }
      }
    }
  }

  @Test
  void product_isExactWhereALongOverflows() {
    long most = Long.MAX_VALUE;
    assertEquals(
        BigInteger.valueOf(most).multiply(BigInteger.valueOf(most)),
        new MixedRadix(List.of(most, most)).product());
    assertEquals(BigInteger.ZERO, new MixedRadix(List.of(most, 0L)).product());
  }
}
