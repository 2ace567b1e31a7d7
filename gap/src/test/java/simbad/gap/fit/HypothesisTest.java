package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Sets of effects with their values, and how probable a log is under them. */
class HypothesisTest {
  private static final Hypothesis CROSSTALK = Worlds.effect(Effect.CROSSTALK, "any", 0.1, 0.5, 2);
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);
  private static final Form SHIFTS = OFFSET.forms().get(0);
  private static final Hypothesis BOTH = CROSSTALK.and(SHIFTS, 0.05);

  // ---------------------------------------------------------------- values

  @Test
  void values_areFormAfterForm() {
    assertEquals(4, BOTH.size());
    assertArrayEquals(new double[] {0.1, 0.5, 2, 0.05}, BOTH.values());
    assertArrayEquals(new double[] {0.1, 0.5, 2}, BOTH.valuesOf(0));
    assertArrayEquals(new double[] {0.05}, BOTH.valuesOf(1));
    List<Parameter> parameters = new ArrayList<>(CROSSTALK.forms().get(0).parameters());
    parameters.addAll(SHIFTS.parameters());
    assertEquals(parameters, BOTH.parameters());
    assertEquals(List.of(Effect.CROSSTALK, Effect.RANGE_OFFSET), BOTH.effects());
    assertEquals(2, BOTH.changes().size());
    assertEquals(SHIFTS.with(0.05), BOTH.changes().get(1));
    assertTrue(BOTH.has(Effect.CROSSTALK) && !BOTH.has(Effect.GAIN));
  }

  @Test
  void values_stayAsTheyWere() {
    double[] values = {0.05};
    Hypothesis set = new Hypothesis(List.of(SHIFTS), values);
    values[0] = 1;
    set.values()[0] = 1;
    assertEquals(OFFSET, set);
    assertEquals(OFFSET.hashCode(), set.hashCode());
    assertNotEquals(OFFSET, OFFSET.with(0.06));
    assertNotEquals(OFFSET, Hypothesis.NONE);
    assertNotEquals(OFFSET.hashCode(), OFFSET.with(0.06).hashCode());
    assertEquals("none", Hypothesis.NONE.toString());
  }

  @Test
  void wrongNumbersOfValues_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> OFFSET.with(1, 2));
    assertThrows(IllegalArgumentException.class, () -> Hypothesis.NONE.and(SHIFTS));
    assertThrows(IllegalArgumentException.class, () -> OFFSET.with(Double.NaN));
  }

  /** The search of an offset ends at a metre. */
  @Test
  void bound_isOfAnyValue() {
    assertFalse(BOTH.isAtBound());
    assertTrue(CROSSTALK.and(SHIFTS, 1).isAtBound());
    assertFalse(Hypothesis.NONE.isAtBound());
  }

  // ---------------------------------------------------------------- likelihoods

  private static CalibratedLog facing(SensingSetup setup, double distanceM, Reading... readings) {
    List<ReadingRow> rows = new ArrayList<>();
    for (Reading reading : readings) {
      Pose pose = Pose.of(0, distanceM, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.05 * rows.size(), pose, reading));
    }
    return new CalibratedLog(setup, List.of(), new PingLog(rows));
  }

  private static double[] nats(CalibratedLog given) {
    return given.logLikelihood(Hypothesis.NONE);
  }

  /**
   * An echo from where nothing is has the broad part alone: a thousandth, of which 0.7 for echoes,
   * one step of 4 m; the finest step is 1 mm. A miss of 0.02 has its broad part of 0.3.
   */
  @Test
  void whatNothingExplains_isOneStepOfAllInAThousand() {
    CalibratedLog stepped = facing(Worlds.POST, 0.5, new Echo(3.9), NoEcho.NO_ECHO);
    assertEquals(Math.log(1e-3 * 0.7 * 0.01 / 4), nats(stepped)[0], 1e-6);
    assertEquals(Math.log(0.999 * 0.02 + 1e-3 * 0.3), nats(stepped)[1], 1e-9);
    SensingSetup fine =
        new SensingSetup(
            Worlds.POST.sensor().withResolution(0), Worlds.POST.scene(), Worlds.POST.noEchoM());
    CalibratedLog exact = facing(fine, 0.5, new Echo(3.9));
    assertEquals(Math.log(1e-3 * 0.7 * 0.001 / 4), nats(exact)[0], 1e-6);
  }

  /** Of an echo 0.98 in 1 says that there is one; what it says of where counts by itself. */
  @Test
  void divided_countsEchoesAndRangesByThemselves() {
    CalibratedLog given = facing(Worlds.POST, 0.5, new Echo(0.45), NoEcho.NO_ECHO, new Echo(0.46));
    double[] whole = nats(given);
    double echo = Math.log(0.999 * 0.98 + 1e-3 * 0.7);
    double[] divided = nats(given.divided(4, 5));
    for (int ping : new int[] {0, 2}) {
      assertEquals(echo / 4 + (whole[ping] - echo) / 5, divided[ping], 1e-9);
    }
    assertEquals(whole[1] / 4, divided[1], 1e-9);
    assertArrayEquals(whole, nats(given.divided(1, 1)), 1e-12);
    assertEquals(whole[1], nats(given.divided(1, 5))[1], 1e-12);
    assertEquals(whole[0] - echo + echo / 4, nats(given.divided(4, 1))[0], 1e-9);
  }

  /** A set-up that is known to be off stays so with another calibration. */
  @Test
  void calibrated_isTheSameLogElse() {
    CalibratedLog given = facing(Worlds.POST, 0.5, new Echo(0.5), NoEcho.NO_ECHO);
    CalibratedLog shifted = given.divided(4, 5).calibrated(OFFSET.changes());
    CalibratedLog anew =
        new CalibratedLog(Worlds.POST, OFFSET.changes(), given.log()).divided(4, 5);
    assertArrayEquals(nats(anew), nats(shifted), 1e-12);
    assertTrue(nats(shifted)[0] > nats(given.divided(4, 5))[0] + 0.5);
    assertEquals(OFFSET.changes(), shifted.calibration());
    assertEquals(List.of(), given.calibration());
    assertSame(given.log(), shifted.log());
    assertSame(Worlds.POST, shifted.setup());
    assertFalse(given.hearsByLevels());
    Form law = LevelWorlds.truth().forms().get(0);
    CalibratedLog levels =
        new CalibratedLog(LevelWorlds.POST, List.of(law.with(law.neutral())), given.log());
    assertTrue(levels.hearsByLevels());
  }

  // ---------------------------------------------------------------- geometries

  private static Geometry turned(CalibratedLog given, double deg) {
    return given.geometry(given.model(Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", deg)));
  }

  /** What changes no geometry looks from where nothing is changed. */
  @Test
  void geometry_isSharedByWhatLooksAlike() {
    CalibratedLog given = facing(Worlds.POST, 0.5, new Echo(0.5));
    Geometry plain = given.geometry(given.model(Hypothesis.NONE));
    assertSame(plain, given.geometry(given.model(OFFSET)));
    assertNotSame(plain, turned(given, 5));
    assertEquals(Math.toRadians(5), turned(given, 5).headingRad(0) - plain.headingRad(0), 1e-12);
  }

  /** The last six are known; what was asked for again is no more the eldest. */
  @Test
  void geometry_isRememberedForAWhile() {
    CalibratedLog given = facing(Worlds.POST, 0.5, new Echo(0.5));
    Geometry first = turned(given, 1);
    Geometry second = turned(given, 2);
    for (int deg = 3; deg <= 6; deg++) {
      turned(given, deg);
    }
    assertSame(first, turned(given, 1));
    turned(given, 7);
    assertSame(first, turned(given, 1));
    assertNotSame(second, turned(given, 2));
  }

  // ---------------------------------------------------------------- clues

  /** Two posts in one cone: each is seen, and heard within 1.5 m of its centre. */
  @Test
  void audible_isOfEachObstacle() {
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    Obstacle behind =
        new Obstacle("behind", new Placement(0, -0.8, 0), post.outline(), post.detection());
    SensingSetup two = new SensingSetup(Worlds.POST.sensor(), new Scene(List.of(post, behind)), 4);
    List<ReadingRow> rows = new ArrayList<>();
    for (double distance : new double[] {0.5, 1}) {
      Pose pose = Pose.of(0, distance, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", distance, pose, new Echo(distance - 0.05)));
    }
    LogClues clues =
        new LogClues(new CalibratedLog(two, List.of(), new PingLog(rows)), Hypothesis.NONE);
    assertArrayEquals(new double[] {0.45, 1.25, 0.95}, clues.audibleM().toArray(), 1e-9);
    assertArrayEquals(new int[] {0, 1}, clues.inCone(0).toArray());
    assertArrayEquals(new int[] {0, 1}, clues.inCone(1).toArray());
    assertEquals(2, clues.obstacles());
    LogClues odd =
        new LogClues(
            new CalibratedLog(two, List.of(), new PingLog(rows)),
            Hypothesis.NONE,
            ping -> ping == 1);
    assertArrayEquals(new int[] {1}, odd.inCone(1).toArray());
  }

  // ---------------------------------------------------------------- fits

  private static CalibratedLog drawn(Hypothesis truth) {
    return Worlds.given(Worlds.read(Worlds.poses(300, 0.3, 1.3, 41), truth, 42));
  }

  /** Two halves of a log that are off to either side are fitted each by itself. */
  @Test
  void refit_isOfThePingsThatCount() {
    List<ReadingRow> poses = Worlds.poses(300, 0.3, 1.3, 41);
    List<ReadingRow> long1 = Worlds.read(poses, OFFSET, 42);
    List<ReadingRow> short1 = Worlds.read(poses, OFFSET.with(-0.05), 42);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      rows.add((i % 2 == 0 ? long1 : short1).get(i));
    }
    CalibratedLog given = Worlds.given(rows);
    for (int odd = 0; odd < 2; odd++) {
      int own = odd;
      Refit refit = new Refit(given, ping -> ping % 2 == own);
      Hypothesis start = OFFSET.with(odd == 0 ? 0.04 : -0.04);
      Hypothesis fitted = refit.of(start, 40);
      assertEquals(odd == 0 ? 0.05 : -0.05, fitted.values()[0], 0.003);
      assertTrue(refit.fitter().logLikelihood(fitted) > refit.fitter().logLikelihood(start));
      assertEquals(Hypothesis.NONE, refit.of(Hypothesis.NONE, 40));
    }
  }

  /** Values before the first that is moved stay. */
  @Test
  void refine_movesTheLaterValues() {
    Hypothesis truth = OFFSET.and(Worlds.effect(Effect.DROPOUT, "single", 0.3).forms().get(0), 0.3);
    Fitter fitter = new Fitter(drawn(truth), Fold.ALL);
    Hypothesis start = truth.with(0.04, 0.1);
    for (Fit fit :
        List.of(
            fitter.refine(start, 1, 60),
            fitter.approach(start, 1, 60),
            fitter.settle(start, 1, 60, 60))) {
      assertEquals(0.04, fit.hypothesis().values()[0]);
      // A share of 0.3 of some 280 pings is known to 0.03; a choice among starts needs less.
      assertEquals(0.3, fit.hypothesis().values()[1], 0.1);
      assertEquals(fitter.logLikelihood(fit.hypothesis()), fit.logLikelihood(), 1e-9);
    }
    // A stride of a sweep is a fifth of the way from nothing or a thirtieth of the interval.
    Fit swept = fitter.sweep(new Fit(start, fitter.logLikelihood(start)), 1);
    assertArrayEquals(new double[] {0.04, 0.13}, swept.hypothesis().values(), 1e-12);
    Fit all = fitter.refine(start, 120);
    assertEquals(0.05, all.hypothesis().values()[0], 0.003);
    Fit near = fitter.polish(truth, 120);
    assertTrue(near.logLikelihood() >= fitter.logLikelihood(truth));
    assertEquals(all.logLikelihood(), near.logLikelihood(), 0.5);
  }

  /** From either end of its interval a value is found as well. */
  @Test
  void refine_leavesTheEndsOfAnInterval() {
    CalibratedLog given = drawn(Hypothesis.NONE);
    for (double end : new double[] {-1, 1}) {
      Fitter fitter = new Fitter(given, Fold.ALL);
      Hypothesis start = OFFSET.with(end);
      Fit swept = fitter.sweep(new Fit(start, fitter.logLikelihood(start)), 0);
      assertTrue(swept.logLikelihood() >= fitter.logLikelihood(start));
      Fit near = fitter.refine(OFFSET.with(0.02 * end), 80);
      assertEquals(0, near.hypothesis().values()[0], 0.003);
    }
  }
}
