package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.world.FixedChance;

/** Where effects of motion can be put in, how large they are, and their names. */
class MotionSiteTest {

  private static final double NEAR = 1e-12;

  private static MotionSite told(boolean differential, double... speeds) {
    double[] times = new double[speeds.length];
    for (int i = 0; i < times.length; i++) {
      times[i] = i;
    }
    return new MotionSite(
        MotionGround.robot(differential, true),
        MotionGround.outing(new Commands(times, speeds, new double[speeds.length])),
        new FixedChance(0.5),
        1);
  }

  @Test
  void sizes_areTimesThePracticalOne() {
    MotionSite site = MotionGround.site(new FixedChance(0.25).coins(true, false), 2);
    assertEquals(0.6, site.sized(0.3), NEAR);
    assertEquals(0.6, site.eitherWay(0.3), NEAR);
    assertEquals(-0.6, site.eitherWay(0.3), NEAR);
    assertEquals(1.6, site.factor(0.3), NEAR);
    assertEquals(1 / 1.6, site.factor(0.3), NEAR);
    assertEquals(3.5, site.between(3, 5), NEAR);
    assertEquals(2, site.size());
    assertThrows(IllegalArgumentException.class, () -> MotionGround.site(new FixedChance(0.5), -1));
  }

  @Test
  void site_knowsWhatIsCommon() {
    MotionSite site = MotionGround.site(new FixedChance(0.5), 1);
    assertEquals(0.3, site.speed(0.5));
    assertEquals(0.8, site.turn(0.7));
    assertEquals(MotionGround.BASE_M, site.baseM());
    assertEquals(100, site.logS());
    MotionSite still = told(true, 0, 0);
    assertEquals(1e-3, still.speed(0.5));
    assertEquals(1e-3, still.turn(0.5));
  }

  /** Six times or more; a rest in between is no change by itself. */
  @Test
  void reversing_isGoingBackOftenEnough() {
    assertTrue(told(true, 1, -1, 1, -1, 0, 1, -1, 1).reverses());
    assertFalse(told(true, 1, -1, 1, -1, 0, 1, -1).reverses());
    assertFalse(told(true, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1).reverses());
    assertTrue(told(true, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1).reverses());
  }

  @Test
  void forms_applyToTheirKindOfRobot() {
    MotionSite wheels = told(true, 1);
    MotionSite unicycle = told(false, 1);
    MotionSite reversing = told(true, 1, -1, 1, -1, 1, -1, 1);
    assertTrue(MotionVocabulary.applies("turn-scale", unicycle));
    assertFalse(MotionVocabulary.applies("caster-kick", wheels));
    assertTrue(MotionVocabulary.applies("caster-kick", reversing));
    assertFalse(MotionVocabulary.applies("nothing", wheels));
    // Of three forms one needs wheels; chance just under the whole takes the last of those left.
    assertEquals("of each wheel", drawn("command-quantization", true));
    assertEquals("cut", drawn("command-quantization", false));
  }

  private static Object drawn(String name, boolean differential) {
    MotionSite site =
        new MotionSite(
            MotionGround.robot(differential, true),
            MotionGround.outing(new Commands(new double[1], new double[] {1}, new double[1])),
            new FixedChance(0.99),
            1);
    return String.valueOf(MotionVocabulary.draw(name, site).parameters().get("form"));
  }

  /** The form first, then the parameters by name: a map has no order of its own. */
  @Test
  void parameters_areSorted() {
    MotionEffect effect = MotionGround.effect("slip", "bouts", 1);
    assertEquals("slip", effect.name());
    assertEquals(
        List.of("form", "least_s", "lost", "most_s", "per_s"),
        new ArrayList<>(effect.parameters().keySet()));
    Map<String, Object> mine = new HashMap<>(Map.of("a", 1));
    MotionEffect copy = new MotionEffect("x", mine, MotionChange.latency(0));
    mine.put("b", 2);
    assertEquals(Map.of("a", 1), copy.parameters());
    assertThrows(UnsupportedOperationException.class, () -> copy.parameters().put("c", 3));
  }

  @Test
  void names_areOfTheVocabularyOrNot() {
    assertTrue(MotionVocabulary.contains("slip"));
    assertFalse(MotionVocabulary.contains("wind"));
    List<String> outside = MotionVocabulary.outside();
    assertEquals(outside.stream().sorted().distinct().toList(), outside);
    assertTrue(outside.contains("wind") && !outside.contains("slip"));
    assertEquals(
        List.of("bouts", "one wheel", "when it speeds up"), MotionVocabulary.forms("slip"));
    assertThrows(
        IllegalArgumentException.class, () -> MotionGround.effect("slip", "no such form", 1));
  }

  @Test
  void pairs_areFairOfTwoStages() {
    assertTrue(MotionVocabulary.isFairPair("slip", "turn-bias"));
    assertFalse(MotionVocabulary.isFairPair("wind", "slip"));
    assertFalse(MotionVocabulary.isFairPair("slip", "motion-noise"));
    assertFalse(MotionVocabulary.isSameStage("slip", "turn-bias"));
    assertFalse(MotionVocabulary.isSameStage("wind", "wind"));
    assertTrue(MotionVocabulary.isSameStage("slip", "motion-noise"));
  }

  @Test
  void otherNames_areWhatPhysicsCannotPart() {
    assertEquals(
        List.of(Set.of("wheel-scale"), Set.of("speed-scale", "turn-scale")),
        MotionVocabulary.accept("wheel-scale"));
    assertEquals(
        List.of(Set.of("actuation-latency"), Set.of("time-offset")),
        MotionVocabulary.accept("actuation-latency"));
    assertEquals(
        List.of(Set.of("time-offset"), Set.of("actuation-latency")),
        MotionVocabulary.accept("time-offset"));
    assertEquals(List.of(Set.of("slip")), MotionVocabulary.accept("slip"));
    assertEquals(
        List.of("command-quantization", "speed-scale"), MotionVocabulary.rivals("dead-band"));
    assertEquals(List.of(), MotionVocabulary.rivals("wind"));
    for (String name : MotionVocabulary.names()) {
      List<String> rivals = MotionVocabulary.rivals(name);
      assertFalse(rivals.contains(name), name);
      assertEquals(new HashSet<>(rivals).size(), rivals.size(), name);
      for (String rival : rivals) {
        assertTrue(MotionVocabulary.rivals(rival).contains(name), name + " and " + rival);
      }
    }
  }
}
