package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.Test;

class SizeCurvesTest {
  private static Truth gain(double size) {
    return new Truth(
        "c" + size,
        List.of("gain"),
        Set.of(),
        false,
        List.of(),
        Optional.empty(),
        Optional.empty(),
        List.of(Set.of("gain")),
        Optional.empty(),
        Optional.of(size),
        Optional.empty());
  }

  /** Found where it is so, wrongly explained elsewhere. */
  private static List<Graded> cases(int count, DoublePredicate found) {
    Random random = new Random(7);
    List<Graded> cases = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double size = Math.exp(Math.log(0.1) + Math.log(100) * random.nextDouble());
      String name = found.test(size) ? "gain" : "absorption";
      cases.add(
          new Graded(gain(size), Optional.of(ScoresTest.answer(Verdict.EXPLAINED, 0.1, name))));
    }
    return cases;
  }

  @SuppressWarnings("unchecked") // As it is written.
  private static Map<String, Object> only(List<Graded> cases) {
    List<Object> lines = SizeCurves.json(cases);
    assertEquals(1, lines.size());
    return (Map<String, Object>) lines.get(0);
  }

  private static Object value(Map<String, Object> line, String name) {
    return Objects.requireNonNull(line.get(name), name);
  }

  private static double number(Map<String, Object> line, String name) {
    return (Double) value(line, name);
  }

  /** A curve of steepness 3 about 0.8: 90 of 100 are found at 0.8 x 9^(1/3) = 1.66. */
  @Test
  void sizesOfACurve_areFoundWithinTheirIntervals() {
    Random chance = new Random(3);
    Map<String, Object> line =
        only(
            cases(
                400, size -> chance.nextDouble() < 1 / (1 + Math.exp(-3 * Math.log(size / 0.8)))));
    assertEquals(0.8, number(line, "size_50"), 0.12);
    assertEquals(1.66, number(line, "size_90"), 0.4);
    List<?> half = (List<?>) value(line, "size_50_ci95");
    assertTrue((Double) half.get(0) < 0.8 && 0.8 < (Double) half.get(1), half.toString());
  }

  @Test
  void alwaysOrNeverFound_isBeyondTheSizesPutIn() {
    assertTrue(number(only(cases(30, size -> true)), "size_90") < 0.2);
    Map<String, Object> never = only(cases(30, size -> false));
    assertTrue(number(never, "size_50") > 8, never.toString());
    assertEquals(new Proportion(30, 30).json(), value(never, "wrongly_explained_below"));
  }

  @Test
  void fewCases_sayNothing() {
    assertEquals(List.of(), SizeCurves.json(cases(5, size -> true)));
    assertEquals(1, SizeCurves.json(cases(6, size -> true)).size());
  }
}
