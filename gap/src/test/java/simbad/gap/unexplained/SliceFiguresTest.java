package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapMeter;
import simbad.gap.slice.Axis;
import simbad.sonar.change.LevelGain;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Figures of slices and signs, of surprises that are set by hand. */
class SliceFiguresTest {
  private static final double EXACT = 1e-9;

  /** Pings of one place, in two runs of which the first has so many. */
  private static List<ReadingRow> rows(int first, int second, IntPredicate heard) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < first + second; i++) {
      Pose pose = Pose.of(0, 0.5 + 1e-4 * i, Math.PI / 2);
      rows.add(
          new ReadingRow(
              i < first ? "a" : "b",
              "s",
              0.1 * i,
              pose,
              heard.test(i) ? new Echo(0.45) : NoEcho.NO_ECHO));
    }
    return rows;
  }

  private static Surprise surprise(
      List<ReadingRow> rows, IntToDoubleFunction expected, IntToDoubleFunction score) {
    Surprise surprise = new Surprise(Worlds.given(rows), Hypothesis.NONE);
    Arrays.setAll(surprise.expected, expected);
    Arrays.setAll(surprise.score, score);
    return surprise;
  }

  private static Misfit.Off off(Misfit misfit, String axis, int from, Misfit.Kind kind) {
    return misfit.slices().stream()
        .filter(one -> one.kind() == kind)
        .filter(one -> one.slice().axis().variable().equals(axis) && one.slice().from() == from)
        .findFirst()
        .orElseThrow();
  }

  /** 60 of 100 where 50 are expected: the deviance of 40 silences over their variance's share. */
  @Test
  void echoesAreOffByTheirDeviance() {
    Misfit misfit = Misfit.of(surprise(rows(100, 0, i -> i < 60), i -> 0.5, i -> 0));
    Misfit.Off all = off(misfit, "sensor", 0, Misfit.Kind.ECHO);
    double deviance = 2 * (40 * Math.log(0.8) + 10);

    assertEquals(Math.sqrt(deviance / 0.5), all.z(), EXACT);
    assertEquals(0.1, all.size(), EXACT);
    assertEquals(100, all.rows());
  }

  /** 30 of 100 where 20 are expected, with a variance of 16; and none at all. */
  @Test
  void rareEchoesAreCountedThemselves() {
    Misfit more = Misfit.of(surprise(rows(100, 0, i -> i < 30), i -> 0.2, i -> 0));
    double deviance = 2 * (30 * Math.log(1.5) - 10);
    assertEquals(Math.sqrt(deviance / 0.8), off(more, "sensor", 0, Misfit.Kind.ECHO).z(), EXACT);
    Misfit none = Misfit.of(surprise(rows(100, 0, i -> false), i -> 0.2, i -> 0));
    assertEquals(-Math.sqrt(2 * 20 / 0.8), off(none, "sensor", 0, Misfit.Kind.ECHO).z(), EXACT);
    assertTrue(none.slices().stream().allMatch(one -> one.kind() == Misfit.Kind.ECHO));
  }

  /**
   * Scores of 1 to either side in one run, of 2 in the other: mean square 2.5, and the squares
   * scatter by 1.5.
   */
  @Test
  void rangesAreOffByTheirScoresAndTheirSquares() {
    Misfit misfit =
        Misfit.of(
            surprise(
                rows(50, 50, i -> true), i -> 0.5, i -> (i < 50 ? 1 : 2) * (i % 2 > 0 ? 1 : -1)));
    double root = Math.sqrt(50);

    Misfit.Off first = off(misfit, "run", 0, Misfit.Kind.SCATTER);
    assertEquals((50 - 125) / (1.5 * root), first.z(), EXACT);
    assertEquals(1, first.size(), EXACT);
    assertEquals((200 - 125) / (1.5 * root), off(misfit, "run", 1, Misfit.Kind.SCATTER).z(), EXACT);
    assertEquals(0, off(misfit, "run", 0, Misfit.Kind.RANGE).z(), EXACT);
    // Every second ping is of one sign.
    assertEquals(75 / Math.sqrt(50 * 2.5), off(misfit, "parity", 1, Misfit.Kind.RANGE).z(), EXACT);
    assertEquals(1.5, off(misfit, "parity", 1, Misfit.Kind.RANGE).size(), EXACT);
  }

  /** Scores of a half: their mean square counts for half at least. */
  @Test
  void scoresThatHardlyScatterAreNotTrusted() {
    Misfit misfit = Misfit.of(surprise(rows(64, 0, i -> true), i -> 0.5, i -> 0.5));

    assertEquals(32 / Math.sqrt(32), off(misfit, "sensor", 0, Misfit.Kind.RANGE).z(), EXACT);
    assertEquals(0, off(misfit, "sensor", 0, Misfit.Kind.SCATTER).z(), EXACT);
  }

  /** Fewer than a dozen pings, or hardly any variance, tell nothing. */
  @Test
  void smallSlicesSayNothing() {
    assertEquals(0, Misfit.of(surprise(rows(11, 0, i -> true), i -> 0.5, i -> 1)).slices().size());
    Misfit sure = Misfit.of(surprise(rows(100, 0, i -> true), i -> 0.99, i -> 1));
    assertTrue(sure.slices().stream().noneMatch(one -> one.kind() == Misfit.Kind.ECHO));
    assertEquals(0, Misfit.of(surprise(rows(11, 0, i -> true), i -> 0.5, i -> 1)).top(5), 0);
  }

  /** Ranges that hang together fourfold are off by half; the greatest come first. */
  @Test
  void theGreatestCountByHowMuchReadingsHangTogether() {
    Misfit ranges = Misfit.of(surprise(rows(64, 0, i -> true), i -> 0.5, i -> 0));
    double most = Math.abs(ranges.slices().get(0).z());
    assertEquals(most, ranges.top(1), EXACT);
    assertEquals(most / 2, ranges.top(1, 4, 1), EXACT);
    Misfit scores = Misfit.of(surprise(rows(64, 0, i -> i < 32), i -> 0.5, i -> 2));
    double range = off(scores, "sensor", 0, Misfit.Kind.RANGE).z();
    assertEquals(32 * 2 / Math.sqrt(32 * 4), range, EXACT);
    assertTrue(scores.top(1, 1e6, 1) >= range - EXACT);
    assertTrue(scores.top(1, 1e6, 1e6) < 0.1);
  }

  /** Twelve blocks of 50: each 25 off, with a variance of 12.5. */
  @Test
  void sumsOverBlocksVaryMoreWhereReadingsHangTogether() {
    List<ReadingRow> rows = rows(600, 0, i -> i / 50 % 2 == 0);
    assertEquals(50, Clumping.ofEchoes(surprise(rows, i -> 0.5, i -> 0)), EXACT);
    assertEquals(
        1, Clumping.ofEchoes(surprise(rows, i -> i / 50 % 2 == 0 ? 0.999 : 0.001, i -> 0)));
    assertEquals(50, Clumping.ofRanges(surprise(rows, i -> 0.5, i -> 1)), EXACT);
    assertEquals(1, Clumping.ofRanges(surprise(rows, i -> 0.5, i -> i % 2 > 0 ? 1 : -1)), 0);
    // A block's squares come to a half only.
    assertEquals(1, Clumping.ofRanges(surprise(rows, i -> 0.5, i -> 0.1)), 0);
  }

  @Test
  void echoesAreAsProbableAsEachIsForItself() {
    Surprise surprise = surprise(rows(4, 0, i -> i < 3), i -> 0.2 * (i + 1), i -> 0);
    double all = Math.log(0.2 * 0.4 * 0.6 * (1 - 0.8));

    assertEquals(all, surprise.echoNats(Fold.ALL), EXACT);
    assertEquals(Math.log(0.4), surprise.echoNats(ping -> ping == 1), EXACT);
    Surprise other = surprise(rows(4, 0, i -> i < 3), i -> 0.5, i -> 3);
    surprise.take(other, 2);
    assertArrayEquals(new double[] {0.2, 0.4, 0.5, 0.8}, surprise.expected, EXACT);
    assertArrayEquals(new double[] {0, 0, 3, 0}, surprise.score, EXACT);
  }

  /** Without a memory a look ahead is what each ping expects, and draws stray by its variance. */
  @Test
  void aLookAheadIsTheSumOfItsPings() {
    CalibratedLog given =
        Worlds.given(Worlds.read(Worlds.poses(400, 1.3, 1.7, 3), Hypothesis.NONE, 4));
    Surprise surprise = new Surprise(given, Hypothesis.NONE);
    boolean[] echo = new boolean[400];
    double[] off = new double[2];
    double[] variance = new double[2];
    for (int i = 0; i < echo.length; i++) {
      echo[i] = given.log().echo(i);
      off[i % 2] += (echo[i] ? 1 : 0) - surprise.expected[i];
      variance[i % 2] += surprise.expected[i] * (1 - surprise.expected[i]);
    }
    Axis parity = Axis.binned("parity", 400, 2, i -> i % 2);
    double[][] found = Foresight.of(given, Hypothesis.NONE).off(parity, echo);

    assertArrayEquals(off, found[0], 0.1);
    for (int at = 0; at < 2; at++) {
      // 80 draws know a deviation to 8 per cent; four of these.
      assertEquals(1, found[1][at] / Math.sqrt(variance[at]), 0.32);
    }
    Axis none = Axis.binned("none", 400, 2, i -> -1);
    assertArrayEquals(new double[2], Foresight.of(given, Hypothesis.NONE).off(none, echo)[1], 0);
  }

  private static double added(List<Change> changes) {
    Change last = changes.get(changes.size() - 1);
    return last instanceof RangeOffset offset ? offset.offsetM() : ((LevelGain) last).gainDb();
  }

  /** Three times what is added: a slope of 3, and a millimetre further 3 mm more. */
  @Test
  void slopesAreDifferencesToEitherSide() {
    SetupScores.Slopes metres =
        SetupScores.metres(
            Hypothesis.NONE, changes -> new double[] {3 * added(changes), -added(changes)});
    assertArrayEquals(new double[] {3, -1}, metres.slope(), EXACT);
    assertArrayEquals(new double[] {0.003, 0.001}, metres.most(), EXACT);
    double[] decibels =
        SetupScores.perDecibel(Hypothesis.NONE, changes -> new double[] {5 * added(changes)});
    assertArrayEquals(new double[] {5}, decibels, EXACT);
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.5);
    double[] two = SetupScores.perMetre(offset, changes -> new double[] {changes.size()});
    assertArrayEquals(new double[] {0}, two, 0);
    assertThrows(
        IllegalArgumentException.class,
        () -> new SetupScores.Slopes(new double[] {Double.NaN}, new double[1]));
  }

  /** What a set-up says of itself. */
  private record Doubt(double times, double gapTimes, double vary, boolean isHeldOut)
      implements SetupDoubt {
    @Override
    public Optional<Leeway> leeway() {
      return Optional.empty();
    }

    @Override
    public double[] blocksVary() {
      return new double[] {vary, vary};
    }

    @Override
    public double misfitTimes(double chance, int rows) {
      return times;
    }
  }

  /** A gap of 10 cm before, of which 6 are left. */
  private static GapGain gain(double expectedM) {
    return new GapGain(
        new GapMeter.Gaps(new double[] {0.1}, new double[] {expectedM}),
        new GapMeter.Gaps(new double[] {0.06}, new double[] {0.03}));
  }

  private static double misfit(Doubt doubt, double expectedM) {
    CalibratedLog given = Worlds.given(rows(300, 0, i -> false));
    return Unknown.signs(given, given, doubt, gain(expectedM), Hypothesis.NONE).misfit();
  }

  /** A silent log is off by far more than the 3 that chance makes. */
  @Test
  void whatASetupIsOffByIsNoSign() {
    CalibratedLog given = Worlds.given(rows(300, 0, i -> false));
    double top = Misfit.of(given, Hypothesis.NONE).top(Misfit.TOP);
    assertTrue(top > 10, () -> "top " + top);
    assertEquals(top - 3, misfit(new Doubt(1, 1, 1, false), 0.08), EXACT);
    assertEquals(top / 2 - 3, misfit(new Doubt(2, 1, 1, false), 0.08), EXACT);
    assertEquals(top / 2 - 3, misfit(new Doubt(1, 1, 4, false), 0.08), EXACT);
    assertEquals(0, misfit(new Doubt(1e6, 1, 1, false), 0.08), 0);
    // Held out, and a gap of 10 cm is within 1.4 times 8 cm but not 7.
    assertEquals(1, misfit(new Doubt(1, 1, 1, true), 0.08), EXACT);
    assertEquals(top - 3, misfit(new Doubt(1, 1, 1, true), 0.07), EXACT);
    Doubt twice = new Doubt(1, 2, 1, false);
    assertEquals(0, Unknown.signs(given, given, twice, gain(0.08), Hypothesis.NONE).left(), EXACT);
    assertEquals("", Unknown.standsIn(given, Hypothesis.NONE));
  }

  @Test
  void signsHaveTheirNames() {
    Map<String, Double> all = new Signs(1, 2, true, 0.5, false, true, false, false).byName();
    assertEquals(List.of(1.0, 2.0, 1.0, 0.5, 0.0, 1.0, 0.0, 0.0), List.copyOf(all.values()));
    assertEquals(1, Signs.NONE.withStandIn().byName().get("stand_in"));
    assertEquals(0, Signs.NONE.byName().get("stand_in"));
    for (int i = 0; i < 3; i++) {
      double[] v = new double[3];
      v[i] = Double.NaN;
      assertThrows(
          IllegalArgumentException.class,
          () -> new Signs(v[0], v[1], false, v[2], false, false, false, false));
    }
  }

  /** The most that signs may say under the one law, a half at least under the other. */
  @Test
  void aRestIsUnknownWhateverSignsSay() {
    ThresholdConstants threshold = new ThresholdConstants(0.1, 0.8, Map.of(), 1, 0.95);
    assertEquals(0.8, threshold.besideARest(0.2), 0);
    assertEquals(0.45, threshold.unknown(Map.of()), EXACT);
    LevelConstants level = new LevelConstants(Map.of(), 1, 0.95);
    assertEquals(0.5, level.besideARest(0.2), 0);
    assertEquals(0.7, level.besideARest(0.7), 0);
    assertThrows(IllegalArgumentException.class, () -> new LevelConstants(Map.of(), 0, 0.95));
    assertThrows(
        IllegalArgumentException.class, () -> new ThresholdConstants(0.1, 1.8, Map.of(), 1, 0.95));
  }

  @Test
  void weightsKeepTheirOrderAndAreFinite() {
    Map<String, Double> weights = new LinkedHashMap<>();
    weights.put("z", 1.0);
    weights.put("a", 2.0);
    assertEquals(List.of("z", "a"), List.copyOf(LawConstants.copy(weights).keySet()));
    weights.put("b", Double.POSITIVE_INFINITY);
    assertThrows(IllegalArgumentException.class, () -> LawConstants.copy(weights));
  }

  private static int[] bins(List<ReadingRow> rows, String axis) {
    CalibratedLog given = Worlds.given(rows);
    Axis cut =
        new Slicing(given.log(), given.geometry(given.model(Hypothesis.NONE)))
            .all().stream().filter(one -> one.variable().equals(axis)).findFirst().orElseThrow();
    return IntStream.range(0, rows.size()).map(cut::bin).toArray();
  }

  /** Readings that rise from ping to ping: each is cut by the one before, the first by none. */
  @Test
  void aReadingIsCutByTheOneBefore() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 13; i++) {
      Pose pose = Pose.of(0, 0.5, Math.PI / 2);
      rows.add(
          new ReadingRow(
              "a", "s", 0.1 * i, pose, i == 12 ? NoEcho.NO_ECHO : new Echo(0.3 + 0.01 * i)));
    }
    // Twelve readings in six slices.
    assertArrayEquals(
        new int[] {-1, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}, bins(rows, "reading before"));
    assertArrayEquals(
        new int[] {-1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, bins(rows, "echo before"));
    assertArrayEquals(new int[] {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0}, bins(rows, "parity"));
  }

  /** After silence there is no reading before, and no echo. */
  @Test
  void silenceIsNoReadingBefore() {
    List<ReadingRow> rows = rows(4, 4, i -> i % 2 == 0);

    assertArrayEquals(new int[] {-1, 1, 0, 1, -1, 1, 0, 1}, bins(rows, "echo before"));
    int[] before = bins(rows, "reading before");
    assertEquals(-1, before[2]);
    assertEquals(-1, before[4]);
    assertTrue(before[1] >= 0);
  }

  private static ObjectNode law(double from, List<String> signs) {
    ObjectNode law = new ObjectMapper().createObjectNode();
    law.put("temperature", from);
    law.put("named_rightly", 0.9);
    ObjectNode unknown = law.putObject("unknown");
    unknown.put("least", 0.01).put("most", 0.7).put("base", -from);
    for (int i = 0; i < signs.size(); i++) {
      unknown.put(signs.get(i), from + i);
    }
    return law;
  }

  @Test
  void constantsAreReadByTheirNames() {
    List<String> ofThresholds = List.copyOf(Signs.NONE.byName().keySet());
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("format", "simbad-constants/2");
    root.set("threshold", law(2, ofThresholds));
    root.set("level", law(3, LevelConstants.SIGNS));
    Constants read = Constants.of(root);

    assertEquals(2, read.threshold().temperature(), 0);
    assertEquals(0.01, read.threshold().least(), 0);
    assertEquals(0.7, read.threshold().most(), 0);
    assertEquals(0.9, read.level().namedRightly(), 0);
    assertEquals(3, read.level().temperature(), 0);
    List<Double> weights = new ArrayList<>(List.of(-3.0));
    for (int i = 0; i < LevelConstants.SIGNS.size(); i++) {
      weights.add(3.0 + i);
    }
    assertEquals(weights, List.copyOf(read.level().weights().values()));
    assertEquals(9, read.threshold().weights().size());
    assertEquals(2.0, read.threshold().weights().get(ofThresholds.get(0)));
  }

  /** Three effects are many, two are not. */
  @Test
  void moreThanTwoAreMany() {
    Hypothesis two =
        Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.03)
            .and(Worlds.effect(Effect.DROPOUT, "single", 0.1).forms().get(0), 0.1);
    Hypothesis three = two.and(Worlds.effect(Effect.GAIN, "factor", 0.9).forms().get(0), 0.9);

    assertEquals(false, Unknown.signs(0, gain(0.08), 1, two, Worlds.POST.scene()).many());
    assertTrue(Unknown.signs(0, gain(0.08), 1, three, Worlds.POST.scene()).many());
  }

  /** Two runs of 16 pings: eight slices of four, two of each run. */
  @Test
  void timeInARunBeginsAnewWithEachRun() {
    int[] bins = bins(rows(16, 16, i -> true), "time in run");

    assertEquals(0, bins[0]);
    assertEquals(0, bins[16]);
    assertEquals(7, bins[15]);
    assertEquals(7, bins[31]);
    for (int i = 1; i < 16; i++) {
      assertTrue(bins[i] >= bins[i - 1]);
    }
  }
}
