package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

class MixtureTest {
  @Property(tries = 500, seed = "21")
  void shareOfRank_isThatWhichSoManyExceed(@ForAll long seed) {
    Random random = new Random(seed);
    double[] shares = random.doubles(random.nextInt(12)).map(x -> x < 0.2 ? 0 : x).toArray();
    Mixture mixture = new Mixture();
    for (double share : shares) {
      mixture.add(1, 0.01, share);
    }
    Arrays.sort(shares);
    for (int rank = 0; rank < 14; rank++) {
      double expected = rank < shares.length ? shares[shares.length - 1 - rank] : 0;
      assertEquals(expected, mixture.shareOfRank(rank));
    }
  }
}
