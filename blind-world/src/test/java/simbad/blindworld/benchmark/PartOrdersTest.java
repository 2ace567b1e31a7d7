package simbad.blindworld.benchmark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simbad.blindworld.generate.Kind;
import simbad.blindworld.generate.Order;
import simbad.blindworld.generate.Worlds;

/** What is drawn for each part: frozen numbers, as its description has them. */
class PartOrdersTest {

  @ParameterizedTest
  @CsvSource({
    "L1, L1, 350, 0, 0, EQUATIONS, 800, 2500", "L2, L2, 350, 1, 1, EQUATIONS, 800, 2500",
    "L2w, L2W, 300, 2, 0, WAVE, 700, 2500", "Motion, MOTION, 300, 3, 0.3, MOTION, 120, 360",
  })
  void half_isWhatThePartSays(
      String word,
      Part part,
      int cases,
      int number,
      double references,
      Worlds worlds,
      int least,
      int most) {
    assertEquals(Optional.of(part), Part.find(word));
    assertEquals(cases, part.cases());
    Order order = part.half(Part.FIRST_HALF);
    assertEquals(cases, order.cases());
    assertEquals(20_271_101 + number, order.seed());
    assertEquals(references, order.referenceShare());
    assertEquals(worlds, order.worlds());
    assertEquals(new Order.Rows(least, most), order.rows());
    assertEquals(Optional.of(new Order.Sizes(0.4, 4)), order.sizes());
    assertEquals(Set.of(Kind.PAIR, Kind.TRIPLE, Kind.UNKNOWN), order.plain());
    assertEquals(200, order.repeats());
  }

  @ParameterizedTest
  @EnumSource
  void mix_isAWhole(Part part) {
    double sum = part.half(1).mix().values().stream().mapToDouble(Double::doubleValue).sum();
    assertEquals(1, sum, 1e-12);
    assertEquals(0.25, part.half(1).mix().get(Kind.NONE));
    assertEquals(0.4, part.half(1).mix().get(Kind.SINGLE));
    assertEquals(0.1, part.half(1).mix().get(Kind.PAIR));
    assertEquals(0.05, part.half(1).mix().get(Kind.TRIPLE));
    assertEquals(0.2, part.half(1).mix().get(Kind.UNKNOWN));
  }

  /** No two parts or practices share their chance, and none is that of the first half. */
  @Test
  void practice_hasChanceOfItsOwn() {
    Set<Long> seeds = new HashSet<>();
    int count = 0;
    for (Part part : Part.values()) {
      seeds.add(part.half(Part.FIRST_HALF).seed());
      count++;
      for (int seed : new int[] {0, 1, 2, Part.MOST_PRACTICE}) {
        Order order = part.practice(seed, 7);
        assertEquals(7, order.cases());
        assertTrue(order.seed() >= 1_000_000_000, order.seed() + "");
        seeds.add(order.seed());
        count++;
      }
    }
    assertEquals(count, seeds.size());
    assertEquals(1_000_000_012L, Part.L2W.practice(1, 7).seed());
  }

  @Test
  void names_haveTheVersion() {
    assertEquals("SRB-1.1 L2w", Part.L2W.toString());
    assertEquals("SRB-1.1 motion", Part.MOTION.toString());
    assertEquals("L2", Part.L2.word());
    assertEquals(Optional.empty(), Part.find("L3"));
  }
}
