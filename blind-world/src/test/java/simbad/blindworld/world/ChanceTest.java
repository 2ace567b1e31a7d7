package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ChanceTest {

  /** Shares beyond whole deviations: Abramowitz and Stegun (1964), table 26.1. */
  private static final double[] BEYOND = {0.5, 0.158655254, 0.022750132, 0.001349898, 3.1671e-5};

  @Test
  void normalNumbers_haveTheirShares() {
    int many = 1_000_000;
    Chance chance = new Chance(7);
    double[] drawn = DoubleStream.generate(chance::nextGaussian).limit(many).toArray();
    for (int x = 0; x < BEYOND.length; x++) {
      for (int sign : new int[] {1, -1}) {
        int from = x;
        double beyond = DoubleStream.of(drawn).filter(d -> sign * d > from).count();
        double expected = many * BEYOND[x];
        double deviation = Math.sqrt(expected * (1 - BEYOND[x]));
        assertEquals(expected, beyond, 4 * deviation, "beyond " + sign * x);
      }
    }
  }

  /** The first numbers of a seed are the same on every Java. */
  @Test
  void normalNumbers_ofASeed_areTheseBits() {
    Chance chance = new Chance(7);
    assertEquals(
        "-0x1.5bcf6ec55b8cfp0 0x1.6f043048400c1p0 -0x1.91f59d2d859b5p-1 -0x1.1bd68baab5bc3p-1",
        IntStream.range(0, 4)
            .mapToObj(i -> Double.toHexString(chance.nextGaussian()))
            .collect(Collectors.joining(" ")));
  }

  @Test
  void furtherChance_sharesNoNumbers() {
    Chance chance = new Chance(7);
    Chance other = chance.split();
    assertNotEquals(chance.nextLong(), other.nextLong());
    assertEquals(new Chance(7).split().nextLong(), new Chance(7).split().nextLong());
  }

  @Test
  void evenNumbers_areBelowOne() {
    Chance chance = new Chance(7);
    double[] drawn = DoubleStream.generate(chance::nextDouble).limit(100_000).toArray();
    assertTrue(DoubleStream.of(drawn).allMatch(d -> d >= 0 && d < 1));
    assertEquals(
        0.5, DoubleStream.of(drawn).average().orElseThrow(), 4 * 0.289 / Math.sqrt(drawn.length));
  }
}
