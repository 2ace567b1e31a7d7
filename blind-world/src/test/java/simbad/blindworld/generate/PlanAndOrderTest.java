package simbad.blindworld.generate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.motionchange.MotionVocabulary;
import simbad.blindworld.wavechange.WaveVocabulary;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Forecast;

/** What is to be drawn, and how plainly readings speak for a forecast. */
class PlanAndOrderTest {

  private static final double NEAR = 1e-9;

  private static Order order(
      int cases, Map<Kind, Double> mix, double references, List<String> effects, Worlds worlds) {
    List<String> withheld = mix.containsKey(Kind.WITHHELD) ? List.of("dropout", "wrap") : List.of();
    return new Order(
        cases,
        5,
        mix,
        references,
        effects,
        withheld,
        new Order.Rows(100, 200),
        10,
        worlds,
        Optional.empty(),
        Set.of());
  }

  private static Map<Kind, Integer> counts(List<Plan.Assignment> plan) {
    Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
    plan.forEach(one -> counts.merge(one.kind(), 1, Integer::sum));
    return counts;
  }

  /** Of 40 cases by weights of 3, 3, 1, 1, 1 and 1; each has its sort of names. */
  @Test
  void plan_hasItsMix() {
    Map<Kind, Double> mix =
        Map.of(
            Kind.NONE,
            3.0,
            Kind.SINGLE,
            3.0,
            Kind.PAIR,
            1.0,
            Kind.UNKNOWN,
            1.0,
            Kind.WITHHELD,
            1.0,
            Kind.TRIPLE,
            1.0);
    List<Plan.Assignment> plan = Plan.of(order(40, mix, 0.25, List.of(), Worlds.EQUATIONS));
    assertEquals(
        Map.of(
            Kind.NONE,
            12,
            Kind.SINGLE,
            12,
            Kind.PAIR,
            4,
            Kind.UNKNOWN,
            4,
            Kind.WITHHELD,
            4,
            Kind.TRIPLE,
            4),
        counts(plan));
    TreeSet<String> ids = new TreeSet<>();
    Set<Long> seeds = new HashSet<>();
    for (Plan.Assignment one : plan) {
      List<String> names = one.names();
      ids.add(one.id());
      seeds.add(one.seed());
      assertTrue(one.id().matches("c[0-9a-f]{7}"), one.id());
      switch (one.kind()) {
        case NONE -> assertEquals(List.of(), names);
        case SINGLE -> assertTrue(names.size() == 1 && isKnown(names.get(0)), names.toString());
        case PAIR -> assertTrue(names.size() == 2 && areFair(names), names.toString());
        case TRIPLE -> assertTrue(names.size() == 3 && areFair(names), names.toString());
        case WITHHELD -> assertTrue(List.of("dropout", "wrap").containsAll(names));
        case UNKNOWN -> assertFalse(Vocabulary.contains(names.get(names.size() - 1)));
      }
    }
    assertEquals(plan.stream().map(Plan.Assignment::id).toList(), List.copyOf(ids));
    assertEquals(40, seeds.size());
    assertEquals(plan, Plan.of(order(40, mix, 0.25, List.of(), Worlds.EQUATIONS)));
  }

  /** Names of the vocabulary's second version come where they are asked for, and only there. */
  @Test
  void furtherNames_comeWhereAskedFor() {
    Map<Kind, Double> singles = Map.of(Kind.SINGLE, 1.0);
    List<String> wanted = List.of("wrap", "gain");
    List<Plan.Assignment> asked = Plan.of(order(8, singles, 0, wanted, Worlds.EQUATIONS));
    assertEquals(4, asked.stream().filter(one -> one.names().equals(List.of("wrap"))).count());
    assertEquals(4, asked.stream().filter(one -> one.names().equals(List.of("gain"))).count());
    List<Plan.Assignment> usual = Plan.of(order(60, singles, 0, List.of(), Worlds.EQUATIONS));
    assertTrue(usual.stream().noneMatch(one -> Vocabulary.further().containsAll(one.names())));
    assertEquals(Set.of(), Worlds.EQUATIONS.unknownAmong(wanted));
    assertEquals(Set.of("wrap"), Worlds.WAVE.unknownAmong(wanted));
  }

  private static boolean isKnown(String name) {
    return Vocabulary.contains(name) && !List.of("dropout", "wrap").contains(name);
  }

  private static boolean areFair(List<String> names) {
    boolean fair = names.stream().allMatch(PlanAndOrderTest::isKnown);
    for (int i = 0; i < names.size(); i++) {
      for (int k = i + 1; k < names.size(); k++) {
        fair &= Vocabulary.isFairPair(names.get(i), names.get(k));
      }
    }
    return fair;
  }

  /** Every fourth case; with a third, of seven cases the third and the sixth. */
  @Test
  void references_areEvenlySpread() {
    List<Plan.Assignment> quarter =
        Plan.of(order(8, Map.of(Kind.NONE, 1.0), 0.25, List.of(), Worlds.EQUATIONS));
    assertEquals(
        List.of(false, false, false, true, false, false, false, true),
        quarter.stream().map(Plan.Assignment::reference).toList());
    List<Plan.Assignment> third =
        Plan.of(order(7, Map.of(Kind.NONE, 1.0), 1 / 3.0, List.of(), Worlds.EQUATIONS));
    assertEquals(
        List.of(false, false, true, false, false, true, false),
        third.stream().map(Plan.Assignment::reference).toList());
    assertTrue(
        Plan.of(order(3, Map.of(Kind.NONE, 1.0), 1, List.of(), Worlds.EQUATIONS)).stream()
            .allMatch(Plan.Assignment::reference));
  }

  /** Each name is used once before one is used again. */
  @Test
  void names_areUsedInTurn() {
    List<String> wanted = List.of("gain", "latency", "dropout");
    List<Plan.Assignment> plan =
        Plan.of(order(12, Map.of(Kind.SINGLE, 1.0), 0, wanted, Worlds.EQUATIONS));
    Map<String, Integer> used = new HashMap<>();
    plan.forEach(one -> used.merge(one.names().get(0), 1, Integer::sum));
    assertEquals(Map.of("gain", 4, "latency", 4, "dropout", 4), used);
    assertThrows(
        IllegalArgumentException.class,
        () -> Plan.of(order(1, Map.of(Kind.PAIR, 1.0), 0, List.of("gain"), Worlds.EQUATIONS)));
    assertThrows(
        IllegalArgumentException.class,
        () -> Plan.of(order(1, Map.of(Kind.UNKNOWN, 1.0), 0, List.of("gain"), Worlds.EQUATIONS)));
    List<String> two = List.of("gain", "latency");
    assertThrows(
        IllegalArgumentException.class,
        () -> Plan.of(order(1, Map.of(Kind.TRIPLE, 1.0), 0, two, Worlds.EQUATIONS)));
  }

  @Test
  void others_areFairBesideTheFirst() {
    Order order = order(1, Map.of(Kind.NONE, 1.0), 0, List.of(), Worlds.EQUATIONS);
    Chance random = new Chance(1);
    for (int i = 0; i < 50; i++) {
      List<String> two = Plan.otherPair(order, "gain", random);
      assertEquals("gain", two.get(0));
      assertTrue(Vocabulary.isFairPair("gain", two.get(1)), two.toString());
      List<String> three = Plan.otherTriple(order, "gain", random);
      assertEquals("gain", three.get(0));
      assertEquals(3, three.size());
      assertTrue(Vocabulary.isFairPair(three.get(1), three.get(2)), three.toString());
      assertTrue(Vocabulary.isFairPair("gain", three.get(2)), three.toString());
    }
    assertTrue(Plan.hasTripleForEach(List.of("gain", "latency", "dropout"), Worlds.EQUATIONS));
    assertFalse(Plan.hasTripleForEach(List.of("gain", "latency", "absorption"), Worlds.EQUATIONS));
    assertTrue(Plan.hasTripleForEach(List.of(), Worlds.EQUATIONS));
  }

  @Test
  void sizes_areLogUniform() {
    Order.Sizes sizes = new Order.Sizes(0.5, 8);
    Chance random = new Chance(2);
    int small = 0;
    for (int i = 0; i < 2000; i++) {
      double size = sizes.draw(random);
      assertTrue(size >= 0.5 && size <= 8, size + "");
      small += size < 1 ? 1 : 0;
    }
    // A quarter of the octaves, give or take five standard errors.
    assertEquals(0.25, small / 2000.0, 0.05);
  }

  /** Without sizes everything has to show, from a half to twice; with them only what is plain. */
  @Test
  void size_growsWhereItHasToShow() {
    Order free = order(1, Map.of(Kind.NONE, 1.0), 0, List.of(), Worlds.EQUATIONS);
    assertTrue(free.hasToShow(Kind.SINGLE));
    Order sized =
        new Order(
            1,
            5,
            Map.of(Kind.NONE, 1.0),
            0,
            List.of(),
            List.of(),
            new Order.Rows(1, 2),
            10,
            Worlds.WAVE,
            Optional.of(new Order.Sizes(3, 3)),
            Set.of(Kind.PAIR));
    assertFalse(sized.hasToShow(Kind.SINGLE));
    assertTrue(sized.hasToShow(Kind.PAIR));
    Chance random = new Chance(3);
    assertEquals(3, sized.size(Kind.SINGLE, 2, random), NEAR);
    assertEquals(12, sized.size(Kind.PAIR, 2, random), NEAR);
    double least = 99;
    double most = 0;
    for (int i = 0; i < 500; i++) {
      double size = free.size(Kind.SINGLE, 1, random);
      least = Math.min(least, size);
      most = Math.max(most, size);
    }
    assertEquals(1, least, 0.05);
    assertEquals(4, most, 0.2);
  }

  @Test
  void worlds_haveTheirVocabularies() {
    assertEquals(Vocabulary.names(), Worlds.EQUATIONS.names());
    assertEquals(WaveVocabulary.names(), Worlds.WAVE.names());
    assertEquals(MotionVocabulary.names(), Worlds.MOTION.names());
    assertEquals(Vocabulary.outside(), Worlds.EQUATIONS.outside());
    assertEquals(WaveVocabulary.outside(), Worlds.WAVE.outside());
    assertEquals(MotionVocabulary.outside(), Worlds.MOTION.outside());
    assertTrue(Worlds.MOTION.contains("slip") && !Worlds.MOTION.contains("gain"));
    assertTrue(Worlds.WAVE.contains("gain") && !Worlds.EQUATIONS.contains("slip"));
    assertTrue(Worlds.MOTION.isFairPair("slip", "turn-bias"));
    assertFalse(Worlds.MOTION.isFairPair("slip", "motion-noise"));
    assertTrue(Worlds.EQUATIONS.isFairPair("gain", "latency"));
    assertFalse(Worlds.WAVE.isFairPair("gain", "absorption"));
    assertEquals(
        Set.of("nothing", "slip"),
        Worlds.WAVE.unknownAmong(List.of("slip", "wind", "nothing", "gain")));
    for (Worlds worlds : Worlds.values()) {
      double sum = 0;
      for (String part : worlds.mix().split(",", -1)) {
        sum += Double.parseDouble(part.split(":", -1)[1]);
      }
      assertEquals(1, sum, NEAR);
    }
  }

  private static Forecast always(double atM, int rows) {
    double[][] quantiles = new double[rows][Forecast.LEVELS];
    for (double[] row : quantiles) {
      java.util.Arrays.fill(row, atM);
    }
    return new Forecast(quantiles);
  }

  /**
   * Blocks of 20 rows gain 10 and 30 cm: 20 in the mean, with a standard deviation of 10 and so an
   * error of 10 / sqrt 2. What is left over of a block counts for nothing.
   */
  @Test
  void evidence_isByBlocks() {
    double[] readings = new double[45];
    for (int row = 0; row < 45; row++) {
      readings[row] = row < 20 ? 1.2 : row < 40 ? 1.6 : 9;
    }
    readings[39] = Double.POSITIVE_INFINITY;
    Evidence.Gain gain = Evidence.of(always(1.3, 45), always(1, 45), readings, 1.6);
    // 1.2 is 20 cm from 1 and 10 from 1.3; 1.6 is 60 and 30.
    assertEquals(20, gain.gainCm(), NEAR);
    assertEquals(20 / (10 / Math.sqrt(2)), gain.standardErrors(), 1e-6);
    Evidence.Gain even =
        Evidence.of(always(1, 40), always(1, 40), java.util.Arrays.copyOf(readings, 40), 1.6);
    assertEquals(0, even.gainCm());
    assertEquals(0, even.standardErrors());
  }
}
