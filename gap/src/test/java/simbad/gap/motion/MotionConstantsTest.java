package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;

class MotionConstantsTest {
  private static final MotionConstants OWN = MotionConstants.own();

  private static Map<String, Double> signs(boolean isNamed, double stranger, double left) {
    return new MotionSigns(isNamed, stranger, left, Map.of()).byName();
  }

  private static double rightly(MotionConstants constants, double stranger, double worth) {
    Map<String, Double> signs =
        new MotionSigns(true, stranger, 0.1, Map.of("turn-bias", worth)).byName();
    return constants.namedRightly(signs, "turn-bias");
  }

  @Test
  void verdicts_addUpToOne() {
    for (double stranger = -6; stranger <= 6; stranger++) {
      for (boolean isNamed : new boolean[] {false, true}) {
        Map<String, Double> signs = signs(isNamed, stranger, 0.1);
        double sum = 0;
        for (Verdict verdict : Verdict.TRUTHS) {
          sum += OWN.verdict(verdict, signs);
        }
        assertEquals(1, sum, 1e-12);
        assertEquals(
            OWN.verdict(Verdict.UNEXPLAINED, signs), OWN.verdict(Verdict.PARTLY, signs), 0);
        assertEquals(0, OWN.verdict(Verdict.UNDECIDED, signs), 0);
      }
    }
  }

  /** Base 0.3 and weights of log odds, by hand. */
  @Test
  void probabilities_areThoseOfTheRegressions() {
    MotionConstants constants =
        new MotionConstants(
            Map.of("base", Math.log(2), "named", -1.0),
            Map.of("base", 0.0, "stranger", 0.5),
            Map.of("base", 1.0, "stranger", -0.5, "worth", 2.0, "scatters", 0.25),
            0.5);
    Map<String, Double> signs = signs(false, 2 * Math.log(5), 0.3);
    assertEquals(2.0 / 8, constants.verdict(Verdict.NONE, signs), 1e-12);
    assertEquals(1.0 / 8, constants.verdict(Verdict.EXPLAINED, signs), 1e-12);
    assertEquals(5.0 / 8, constants.verdict(Verdict.UNEXPLAINED, signs), 1e-12);
    assertEquals(1 / (1 + Math.exp(-0.4)), rightly(constants, 3, 0.45), 1e-12);
    // What has no worth only scatters.
    double noise = constants.namedRightly(signs(true, 3, 0.3), "motion-noise");
    assertEquals(1 / (1 + Math.exp(0.25)), noise, 1e-12);
  }

  /** What the words promise, of whatever is fitted. */
  @Test
  void fittedConstants_doubtWhereSomethingIsLeft() {
    double calm = OWN.verdict(Verdict.EXPLAINED, signs(true, -5, 0.02));
    assertTrue(calm > 0.8, "" + calm);
    assertTrue(calm > OWN.verdict(Verdict.EXPLAINED, signs(true, -5, 0.6)));
    assertTrue(calm > OWN.verdict(Verdict.EXPLAINED, signs(true, 4, 0.02)));
    assertTrue(OWN.verdict(Verdict.NONE, signs(false, -5, 0.02)) > 0.8);
    assertTrue(OWN.verdict(Verdict.UNEXPLAINED, signs(false, 6, 0.3)) > 0.8);
    assertTrue(rightly(OWN, -5, 1) > rightly(OWN, 5, 1));
    assertTrue(rightly(OWN, 5, 2) > rightly(OWN, 5, -2));
    assertTrue(rightly(OWN, 5, -2) < 0.5, "a shadow of something without a name");
  }

  /** Twice as much is taken away as is left; nothing is; and nothing is left. */
  @Test
  void worth_isWhatIsTakenAwayOverWhatIsLeft() {
    assertEquals(Math.log(2), MotionSigns.worth(0.3, 0.15), 1e-12);
    assertEquals(Math.log(0.001 / 0.2), MotionSigns.worth(-0.1, 0.2), 1e-12);
    assertEquals(Math.log(500), MotionSigns.worth(0.5, -0.01), 1e-12);
    Map<String, Double> signs =
        new MotionSigns(true, 1, 0.1, Map.of("slip", 0.5, "dead-band", -1.0)).byName();
    assertEquals(Double.valueOf(-1), signs.get("worth_dead-band"));
    assertEquals(List.of("dead-band", "slip"), MotionConstants.weighed(signs));
  }

  @Test
  void surerThanSure_countsAsSure() {
    MotionUnknown certain = new MotionUnknown(List.of(), 1);
    MotionConclusion conclusion =
        new MotionConclusion(List.of(), List.of(), List.of(), certain, true, 0.8, 0.6);
    double[][] none = new double[3][3];
    MotionSigns signs =
        MotionSigns.of(
            conclusion,
            new MotionDiagnosis.Gap(
                9, none, none, none, 0.8, new Interval(0.7, 0.9), new Interval(0.5, 1.1), 0.6),
            Map.of());
    assertEquals(Math.log(999), signs.strangerLogOdds(), 1e-9);
    assertEquals(0.25, signs.left(), 1e-12);
    assertEquals(
        Map.of(
            "named", 0.0,
            "stranger", signs.strangerLogOdds(),
            "stranger_beside", 0.0,
            "left_beside", 0.0,
            "left_alone", signs.left()),
        signs.byName());
  }

  @ParameterizedTest
  @ValueSource(strings = {"none", "unexplained", "named_rightly", "other_drive", "format"})
  void aFieldThatIsMissing_isNamed(String field) {
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("format", "simbad-motion-constants/1");
    for (String part : new String[] {"none", "unexplained", "named_rightly"}) {
      ObjectNode weights = root.putObject(part);
      OWN.none().keySet().forEach(name -> weights.put(name, 0.1));
      OWN.namedRightly().keySet().forEach(name -> weights.put(name, 0.1));
    }
    root.put("other_drive", 0.5);
    assertEquals(0.5, MotionConstants.of(root).otherDrive());
    root.remove(field);
    String message =
        Objects.toString(
            assertThrows(IllegalArgumentException.class, () -> MotionConstants.of(root))
                .getMessage());
    String named = field.equals("format") || field.equals("other_drive") ? field : "base";
    assertTrue(message.startsWith(named + ":"), message);
  }

  @Test
  void whatIsNoNumber_isRefused() {
    Map<String, Double> bad = Map.of("base", Double.NaN);
    Map<String, Double> good = Map.of("base", 0.0);
    assertThrows(IllegalArgumentException.class, () -> new MotionConstants(bad, good, good, 0.5));
    assertThrows(IllegalArgumentException.class, () -> new MotionConstants(good, bad, good, 0.5));
    assertThrows(IllegalArgumentException.class, () -> new MotionConstants(good, good, bad, 0.5));
    assertThrows(
        IllegalArgumentException.class, () -> new MotionConstants(good, good, good, Double.NaN));
  }
}
