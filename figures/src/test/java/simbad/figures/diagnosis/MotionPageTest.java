package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;

class MotionPageTest {
  private static final Provenance ORIGIN = new Provenance(Map.of(), "1.2 <dirty>", 1);

  private static String page(Verdict verdict, List<MotionFinding> findings) {
    double[][] before = {{0.004, 0.001, 0.02}, {0.01, 0.002, 0.03}, {0.02, 0.01, 0.05}};
    double[][] after = {{0.002, 0.001, 0.01}, {0.005, 0.002, 0.02}, {0.01, 0.01, 0.04}};
    MotionDiagnosis diagnosis =
        new MotionDiagnosis(
            verdict,
            "the gap shrinks by 40 %",
            findings,
            0.2,
            before,
            after,
            0.4,
            new Interval(0.35, 0.45),
            new double[3],
            new double[3],
            List.of(new MotionPlace("speed_m_s", 0, 0.1, 50, 0.3, 1.2, 0.7)),
            100);
    return MotionPage.of("a<b>", diagnosis, ORIGIN);
  }

  @Test
  void namesValuesTiesAndGap_areSaid() {
    String page =
        page(
            Verdict.EXPLAINED,
            List.of(
                new MotionFinding(
                    "speed-scale",
                    "speed-scale",
                    0.97,
                    List.of(
                        new MotionFinding.Parameter(
                            "speed_factor", 0.95, new Interval(0.94, 0.96), false)),
                    List.of("wheel-scale"),
                    "multiply commanded speeds by 0.95")));

    assertTrue(page.contains("<strong>explained</strong>: the gap shrinks by 40 %."));
    assertTrue(page.contains("speed-scale (needed: 97&nbsp;%)"));
    assertTrue(page.contains("0.94 to 0.96"));
    assertTrue(page.contains("does not tell it from wheel-scale."));
    assertTrue(page.contains("<td class=\"n\">4.00&nbsp;mm</td><td class=\"n\">2.00&nbsp;mm</td>"));
    assertTrue(page.contains("<code>speed_m_s</code>"));
    assertTrue(page.contains("A first version"));
  }

  @Test
  void whatIsNotOurs_staysText() {
    String page = page(Verdict.NONE, List.of());

    assertTrue(page.contains("a&lt;b&gt;") && page.contains("1.2 &lt;dirty&gt;"));
    assertFalse(page.contains("a<b>"));
    assertTrue(page.contains("No effect is named."));
  }
}
