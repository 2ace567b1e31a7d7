package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Ladders;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;

/** One reading in four of a ladder fits nothing: by chance, or as the distance has it. */
class StraysTest {
  private static final double SHARE = 0.25;

  /** From 0 to 4 m. */
  private static final double[] WIDE = {SHARE, 0, 4};

  private static boolean goWithDistance(Ladders.Fault fault, long seed, String form) {
    CalibratedLog given =
        new CalibratedLog(
            Ladders.BOARD, List.of(), new PingLog(Ladders.untimed(Ladders.read(fault, seed))));
    Form of = Forms.find(Effect.CROSSTALK, form, Ladders.BOARD, List.of("s")).orElseThrow();
    double[] tries = of.parameters().stream().mapToDouble(p -> p.tries().get(0)).toArray();
    Hypothesis crosstalk = Hypothesis.NONE.and(of, form.equals("any") ? WIDE : tries);
    return Strays.of(given, crosstalk).goWithDistance();
  }

  /** Another sonar's pings come at any time: two such ladders in a hundred are taken for more. */
  @Test
  void strayReadings_hardlyEverGoWithTheDistance() {
    int found = 0;
    for (int seed = 1; seed <= 40; seed++) {
      Random other = new Random(1000 + seed);
      boolean goes =
          goWithDistance(
              (range, lot) -> lot < SHARE ? 0.02 + 3.9 * other.nextDouble() : range, seed, "any");
      found += goes ? 1 : 0;
    }
    // Binomial of 40 with 2 %: more than four have a chance of 0.1 %.
    assertEquals(true, found <= 4, found + " of 40");
  }

  /** Half the way, or the same stray reading again at each place. */
  @ParameterizedTest
  @CsvSource({"any, true", "walking, false"})
  void readingsThatGoWithThePlace_doSo(String form, boolean isAsked) {
    assertEquals(
        isAsked, goWithDistance((range, lot) -> lot < SHARE ? 0.5 * range + 0.2 : range, 5, form));
    assertEquals(
        isAsked,
        goWithDistance(
            (range, lot) -> lot < SHARE ? 2 + Math.sin(50 * Math.rint(20 * range)) : range,
            6,
            form));
  }

  @Test
  void withoutCrosstalk_nothingIsAsked() {
    CalibratedLog given =
        new CalibratedLog(
            Ladders.BOARD, List.of(), new PingLog(Ladders.read((range, lot) -> range, 1)));
    assertEquals(false, Strays.of(given, Hypothesis.NONE).goWithDistance());
  }
}
