package simbad.gap.joint;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;

/** What was found of the readings of a joint log. */
final class SensingHalf {
  private SensingHalf() {}

  static Diagnosis of(Verdict verdict, double unknown, List<Effect> named, Hypothesis fitted) {
    return new Diagnosis(
        verdict,
        "",
        named,
        List.of(),
        unknown,
        0.5,
        List.of(),
        new GapFigures(2, 3, 1.5, 1, 0.5, new Interval(0.4, 0.6)),
        List.of(),
        List.of(),
        List.of(),
        Optional.empty(),
        fitted,
        Hypothesis.NONE,
        List.of(),
        Map.of(),
        Optional.empty(),
        List.of());
  }
}
