package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Verdict;

/** What a verdict needs beside names. */
class MotionConclusionTest {
  private static final MotionUnknown NOTHING = new MotionUnknown(List.of(), 0);
  private static final MotionUnknown SOMETHING = new MotionUnknown(List.of(), 0.9);

  private static MotionFinding finding(String effect) {
    return new MotionFinding(effect, effect, 0.99, List.of(), List.of(), "");
  }

  private static MotionConclusion of(
      List<MotionFinding> named, MotionUnknown unknown, double gap, double floor) {
    return new MotionConclusion(named, List.of(), List.of(), unknown, true, gap, floor);
  }

  @Test
  void noName_besideMoreThanTwoFloors_isUndecided() {
    MotionConclusion left = of(List.of(), NOTHING, 1, 0.44);

    assertEquals(Verdict.NONE, of(List.of(), NOTHING, 1, 0.51).verdict());
    assertEquals(Verdict.UNDECIDED, left.verdict());
    assertTrue(left.headline(0).contains("2.3 times what scatter alone leaves"), left.headline(0));
    assertTrue(left.isAsBelieved());
  }

  @Test
  void nameThatDoesNotShrinkTheGap_isNoExplanation() {
    List<MotionFinding> slip = List.of(finding("slip"));
    MotionConclusion more = of(slip, NOTHING, 1.013, 0.46);

    assertEquals(Verdict.EXPLAINED, of(slip, NOTHING, 0.965, 0.22).verdict());
    assertEquals(Verdict.UNDECIDED, more.verdict());
    assertEquals(List.of(), more.explanation());
    assertTrue(more.headline(-0.013).contains("it grows by 1.3 %"), more.headline(-0.013));
    assertTrue(more.isAsBelieved());
    assertEquals(Verdict.UNEXPLAINED, of(slip, SOMETHING, 1.013, 0.46).verdict());
    assertEquals(Verdict.PARTLY, of(slip, SOMETHING, 0.965, 0.22).verdict());
  }

  @Test
  void partly_saysNoNameThatIsLessProbableThanAnyOther() {
    MotionConclusion partly = of(List.of(finding("saturation")), SOMETHING, 0.6, 0.25);
    MotionConclusion doubted = partly.doubting(one -> 0.25, one -> 0.99);

    assertEquals(Verdict.PARTLY, partly.doubting(one -> 0.85, one -> 0.99).verdict());
    assertEquals(Verdict.UNEXPLAINED, doubted.verdict());
    assertEquals(List.of(), doubted.explanation());
    assertEquals(0.25 * 0.99, doubted.others(partly.named(), one -> 1).get(0).probability(), 1e-12);
    assertEquals(
        Verdict.EXPLAINED,
        of(partly.named(), NOTHING, 0.6, 0.25).doubting(one -> 0.25, one -> 0.99).verdict());
  }

  /** What may be the shadow of something without a name is no likelier than not, nor than that. */
  @Test
  void shadow_isAsLikelyAsSuchNamesAre() {
    List<MotionFinding> names = List.of(finding("saturation"));
    MotionConclusion shadowed =
        new MotionConclusion(
            List.of(), List.of(), List.of("saturation"), SOMETHING, true, 0.6, 0.25);

    assertEquals(0.5, shadowed.others(names, one -> 1).get(0).probability(), 0);
    double weight = names.get(0).probability();
    assertEquals(0.2 * weight, shadowed.others(names, one -> 0.2).get(0).probability(), 1e-12);
  }
}
