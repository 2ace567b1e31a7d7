package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.LongStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;

class PermutationTest {
  @Property(seed = "20261121")
  void everyNumber_standsOnce(@ForAll @IntRange(min = 1, max = 3000) int size, @ForAll long seed) {
    Permutation order = new Permutation(size, seed);
    assertArrayEquals(
        LongStream.range(0, size).toArray(),
        LongStream.range(0, size).map(order::at).sorted().toArray());
  }

  @Property(seed = "20261121")
  void numbersOfAGreatProduct_areDifferentAndInside(
      @ForAll @LongRange(min = 5000, max = Permutation.GREATEST_SIZE) long size,
      @ForAll long seed) {
    Permutation order = new Permutation(size, seed);
    Set<Long> numbers = new HashSet<>();
    for (long place = 0; place < 50; place++) {
      long number = order.at(place);
      assertTrue(number >= 0 && number < size, number + " of " + size);
      numbers.add(number);
    }
    assertEquals(50, numbers.size());
  }

  /**
   * 20,000 of 1,000,000 in ten classes of equal size: chi-square with 9 degrees of freedom exceeds
   * 27.9 by chance once in 1000 times; the seed is fixed.
   */
  @Test
  void sample_isSpreadEvenly() {
    Permutation order = new Permutation(1_000_000, 7);
    double[] counts = new double[10];
    for (int place = 0; place < 20_000; place++) {
      counts[(int) (order.at(place) / 100_000)]++;
    }
    double chiSquare = 0;
    for (double count : counts) {
      chiSquare += Math.pow(count - 2000, 2) / 2000;
    }
    assertTrue(chiSquare < 27.9, "chi-square " + chiSquare);
  }
}
