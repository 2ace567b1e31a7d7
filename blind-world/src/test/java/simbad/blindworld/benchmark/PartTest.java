package simbad.blindworld.benchmark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PartTest {
  @ParameterizedTest
  @EnumSource
  void everyPart_isFrozenByTheRootOfAllItsCases(Part part) {
    assertTrue(part.root().matches("[0-9a-f]{64}"), part + ": " + part.root());
  }

  @Test
  void noTwoParts_haveOneRoot() {
    long roots = Arrays.stream(Part.values()).map(Part::root).distinct().count();
    assertEquals(Part.values().length, roots);
  }
}
