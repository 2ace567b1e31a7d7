package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Modes;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** From where fits start: what the readings themselves point to. */
class ClueSearchesTest {
  private static PingLog log(double... rangesM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (double rangeM : rangesM) {
      rows.add(new ReadingRow("r", "s", 0.05 * rows.size(), Pose.of(1, 0, 0), new Echo(rangeM)));
    }
    return new PingLog(rows);
  }

  private static LogClues clues(List<ReadingRow> poses, Hypothesis truth) {
    return new LogClues(Worlds.given(Worlds.read(poses, truth, 12)), Hypothesis.NONE);
  }

  private static void assertSome(List<double[]> starts, Predicate<double[]> near) {
    assertTrue(
        starts.stream().anyMatch(near),
        () -> starts.stream().map(Arrays::toString).toList().toString());
  }

  // ---------------------------------------------------------------- steps

  /** Whole steps of a length keep its beat; the best is one that nearly all readings are on. */
  @ParameterizedTest
  @ValueSource(doubles = {0.046, 0.025, 0.17})
  void rhythm_isThatOfTheReadings(double stepM) {
    Random random = new Random(4);
    double[] rangesM = random.ints(60, 2, 12).mapToDouble(steps -> steps * stepM).toArray();
    List<Double> steps = new Rhythm(log(rangesM)).steps();
    assertTrue(steps.subList(0, 16).contains(stepM), steps.toString());
    double best = steps.get(0);
    double off =
        DoubleStream.of(rangesM)
            .map(r -> Math.abs(Math.IEEEremainder(r, best)))
            .max()
            .orElseThrow();
    assertTrue(off < best / 8, best + " m is " + off + " m off");
    assertTrue(steps.stream().allMatch(step -> step >= 0.008 && step <= 0.3), steps.toString());
    assertTrue(steps.containsAll(List.of(0.01, 0.055, 0.1)), steps.toString());
  }

  // ---------------------------------------------------------------- lines

  /** Every second reading is half of the one before less 0.2 m, to 3 mm; the others are any. */
  @Test
  void line_isThatOnWhichTheEchoesLie() {
    Random random = new Random(5);
    double[] rangesM = new double[200];
    for (int i = 0; i < rangesM.length; i += 2) {
      rangesM[i] = random.nextDouble(1, 4);
      rangesM[i + 1] = 0.5 * rangesM[i] - 0.2 + random.nextDouble(-0.003, 0.003);
    }
    int[] second = IntStream.range(0, 100).map(i -> 2 * i + 1).toArray();
    List<Clues.Line> lines = new LineSearch(log(rangesM), second).best();
    assertEquals(0.5, lines.get(0).slope(), 0.01);
    assertEquals(0.2, lines.get(0).shiftM(), 0.01);
    assertEquals(100, lines.get(0).votes());
    assertEquals(3, lines.size());
    assertTrue(lines.get(1).votes() >= lines.get(2).votes() && lines.get(1).votes() < 60);
    for (int i = 0; i < 3; i++) {
      double apart = Math.abs(lines.get(i).slope() - lines.get((i + 1) % 3).slope());
      assertTrue(apart >= 0.1 - 1e-9, lines.toString());
    }
    assertEquals(List.of(), new LineSearch(log(1, 2)).best());
  }

  // ---------------------------------------------------------------- crowds

  @Test
  void modes_areWhereValuesCrowd() {
    double[] values = {1.01, 1.0, 0.99, 1.02, 3.0, 2.51, 2.5, 2.49};
    assertEquals(List.of(1.01, 2.5), Modes.of(DoubleStream.of(values), 0.1, 2));
    assertEquals(List.of(1.01), Modes.of(DoubleStream.of(values), 0.1, 1));
    assertEquals(List.of(), Modes.of(DoubleStream.empty(), 0.1, 3));
    double[] sorted = {0, 1, 2, 3, 4};
    assertEquals(0, Modes.quantile(sorted, 0));
    assertEquals(2, Modes.quantile(sorted, 0.5));
    assertEquals(4, Modes.quantile(sorted, 1));
  }

  // ---------------------------------------------------------------- faces

  private static List<ReadingRow> lookingRound() {
    Random random = new Random(11);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 600; i++) {
      Pose pose =
          Pose.of(
              random.nextDouble(-2, 1),
              random.nextDouble(-2, 2),
              random.nextDouble(0, 2 * Math.PI));
      rows.add(new ReadingRow("r", "s", 0.05 * i, pose, NoEcho.NO_ECHO));
    }
    return rows;
  }

  /** A wall across x = 1.5 m from z = -0.3 m to 0.9 m, turned by 3 degrees from the page. */
  @ParameterizedTest
  @ValueSource(strings = {"mirror", "face"})
  void face_isWhereEchoesAgree(String name) {
    double[] wall = {1.5, 0.3, 177, 0.6, 0.95, 30, 4};
    Form form = Forms.find(Effect.UNMODELLED_OBJECT, name, Worlds.POST, List.of("s")).orElseThrow();
    double[] values = Arrays.copyOf(wall, form.parameters().size());
    Hypothesis truth = Hypothesis.NONE.and(form, values);
    List<double[]> starts = new FaceSearch(clues(lookingRound(), truth)).starts(form);
    double normal = Math.toRadians(177);
    // A face's end answers whoever stands beside it: it looks wider than it is.
    double widest = name.equals("mirror") ? 0.8 : 1.2;
    assertSome(
        starts,
        s ->
            Math.abs(Math.IEEEremainder(s[2] - 177, 360)) <= 2
                && Math.abs((s[0] - 1.5) * Math.cos(normal) - (s[1] - 0.3) * Math.sin(normal))
                    < 0.03
                && Math.hypot(s[0] - 1.5, s[1] - 0.3) < 0.25
                && s[3] > 0.4
                && s[3] < widest);
  }

  /** As far as all but one in fifty of its echoes came, and 5 cm more; as wide as was seen. */
  @Test
  void face_reachesAsFarAsItsEchoesCame() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "face", 1.5, 0.3, 177, 0.6, 0.95, 30, 2);
    LogClues clues = clues(lookingRound(), truth);
    double[] ranges = clues.strangeEchoes().mapToDouble(clues.log()::rangeM).sorted().toArray();
    double farthest = ranges[(int) Math.rint(0.98 * (ranges.length - 1))];
    List<double[]> starts = new FaceSearch(clues).starts(truth.forms().get(0));
    double[] first = starts.get(0);
    assertEquals(farthest + 0.05, first[6], 0.02);
    assertEquals(0.95, first[4]);
    // Seven squares with the width that was seen, then as wide as a room.
    assertEquals(List.of(8.0, 12.0), List.of(first[5], starts.get(1)[5]));
    assertEquals(first[3], starts.get(6)[3]);
    assertEquals(8, starts.get(7)[3]);
  }

  @Test
  void face_withoutAnyStrangeEcho_startsAnywhere() {
    Form form =
        Forms.find(Effect.UNMODELLED_OBJECT, "face", Worlds.POST, List.of("s")).orElseThrow();
    LogClues silent = new LogClues(Worlds.given(lookingRound().subList(0, 5)), Hypothesis.NONE);
    List<double[]> starts = new FaceSearch(silent).starts(form);
    assertTrue(!starts.isEmpty() && starts.get(0).length == form.parameters().size());
  }

  // ---------------------------------------------------------------- walks

  /** Foreign pings walk by 13 cm a ping within 3 m. */
  @Test
  void walk_isThatOfTheEchoes() {
    Hypothesis truth = Worlds.effect(Effect.CROSSTALK, "walking", 0.6, 0, 3, 0.13, 0.4, 0.005);
    Form form = Forms.find(Effect.CROSSTALK, "walking", Worlds.POST, List.of("s")).orElseThrow();
    List<double[]> starts = new WalkSearch(clues(lookingRound(), truth)).starts(form);
    assertSome(
        starts,
        s ->
            Math.abs(s[3] - 0.13) < 0.001
                && Math.abs(s[2] - 3) < 0.03
                && Math.abs(s[4] - 0.4) < 0.05);
    assertTrue(starts.stream().allMatch(s -> s[0] > 0.3 && s[0] <= 0.7), "shares");
  }

  @Test
  void walk_withoutStrangeEchoes_isNeutral() {
    Form form = Forms.find(Effect.CROSSTALK, "walking", Worlds.POST, List.of("s")).orElseThrow();
    LogClues silent = new LogClues(Worlds.given(lookingRound().subList(0, 5)), Hypothesis.NONE);
    List<double[]> starts = new WalkSearch(silent).starts(form);
    assertEquals(1, starts.size());
    assertEquals(0, starts.get(0)[0]);
  }
}
