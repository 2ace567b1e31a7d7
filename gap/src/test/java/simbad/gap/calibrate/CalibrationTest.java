package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.unexplained.Misfit;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class CalibrationTest {
  private static PingLog log(Hypothesis world, int rows, long seed) {
    return new PingLog(Worlds.read(Worlds.poses(rows, 0.3, 2.2, seed), world, seed + 1));
  }

  private static Hypothesis setup(String name, double... values) {
    Form form =
        SetupForms.all(Worlds.POST).stream()
            .filter(one -> one.name().equals(name))
            .findFirst()
            .orElseThrow();
    return Hypothesis.NONE.and(form, Arrays.copyOf(values, form.parameters().size()));
  }

  private static CalibratedLog calibrated(Calibration calibration, PingLog log) {
    return new CalibratedLog(Worlds.POST, calibration.setup().changes(), log);
  }

  /** What chance makes of a right set-up predicts another log hardly worse. */
  @Test
  void rightSetup_staysRight() {
    for (long seed = 1; seed <= 3; seed++) {
      Calibration calibration = Calibration.of(Worlds.POST, log(Hypothesis.NONE, 1500, seed));
      PingLog other = log(Hypothesis.NONE, 1500, seed + 10);
      double right =
          new Fitter(new CalibratedLog(Worlds.POST, List.of(), other), Fold.ALL)
              .logLikelihood(Hypothesis.NONE);
      double fitted =
          new Fitter(calibrated(calibration, other), Fold.ALL).logLikelihood(Hypothesis.NONE);
      assertEquals(right, fitted, 12);
      double clumping = calibration.clumping();
      assertTrue(clumping < 2.5, () -> "clumping " + clumping);
    }
  }

  /** Thresholds that wave by 3 % come back within 1 %. */
  @Test
  void wavesOfTheThresholds_areFound() {
    Hypothesis world = setup("threshold:post", 0, 0.03, 0, 0, -0.03);
    Calibration calibration = Calibration.of(Worlds.POST, log(world, 3000, 3));
    Hypothesis found = calibration.setup();
    int at = found.forms().indexOf(world.forms().get(0));
    assertTrue(at >= 0, () -> found.toString());
    double[] waves = found.valuesOf(at);
    assertEquals(0, waves[0], 0.01);
    assertEquals(0.03, waves[1], 0.01);
    assertEquals(-0.03, waves[4], 0.01);
  }

  @Test
  void whatTheReferenceShowsToo_belongsToTheSetup() {
    Hypothesis wider = Worlds.effect(Effect.GAIN, "factor", 0.9);
    Hypothesis clamp = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.03);
    Hypothesis world = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.03);
    Calibration calibration = Calibration.of(Worlds.POST, log(world, 1200, 5));
    CalibratedLog given = calibrated(calibration, log(world, 1500, 7));
    Calibration more = calibration.with(given, clamp);
    Hypothesis found = more.setup();
    int at = found.forms().indexOf(SetupForms.of(clamp.forms().get(0)));
    assertTrue(at >= 0, () -> found.toString());
    assertEquals(0.03, found.valuesOf(at)[0], 0.002);
    // A gain that only the log shows stays an effect.
    CalibratedLog weaker =
        calibrated(more, log(world.and(wider.forms().get(0), wider.values()), 1500, 9));
    assertSame(more, more.with(weaker, wider));
  }

  @Test
  void withoutReference_nothingChanges() {
    Calibration none = Calibration.none();
    PingLog log = log(Hypothesis.NONE, 300, 11);
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.9);
    assertSame(none, none.with(calibrated(none, log), gain));
    CalibratedLog given = calibrated(none, log);
    assertSame(given, none.loosened(given, gain));
  }

  /** A reference far from any edge leaves the edges' softness open: the log may decide it. */
  @Test
  void whatTheReferenceLeavesOpen_isNoMisfit() {
    Hypothesis soft = setup("scatter", 0.1, 0.004, 0.005);
    PingLog near = new PingLog(Worlds.read(Worlds.poses(800, 0.3, 1.2, 15), soft, 16));
    Calibration calibration = Calibration.of(Worlds.POST, near);
    PingLog edges = new PingLog(Worlds.read(Worlds.poses(2000, 1.7, 2.3, 17), soft, 18));
    CalibratedLog given = calibrated(calibration, edges);
    double held = Misfit.of(given, Hypothesis.NONE).top(5);
    CalibratedLog loosened = calibration.loosened(given, Hypothesis.NONE);
    double loose = Misfit.of(loosened, Hypothesis.NONE).top(5);
    assertTrue(held > 4 && loose < 3, () -> held + " and loosened " + loose);
  }

  /** Of a quadratic likelihood the worth is exact: sqrt(1+vc) shrinks, g^2 v / (1+vc) gains. */
  @Test
  void worthOfWaves_isTheirMarginalLikelihood() {
    Waves.Lie lie = new Waves.Lie(new double[] {30, 0}, new double[] {100, 0});
    assertEquals(0, lie.worth(0), 1e-12);
    double known = 1 + 0.04 * 100;
    assertEquals((900 * 0.04 / known - Math.log(known)) / 2, lie.worth(0.04), 1e-12);
  }

  @Test
  void waves_moveToTheBestAndBackWithATightPrior() {
    Form form = setup("threshold:post").forms().get(0);
    PingLog log = log(setup("threshold:post", 0.05), 2000, 13);
    Fitter fitter = new Fitter(new CalibratedLog(Worlds.POST, List.of(), log), Fold.ALL);
    double[] wide = new double[form.parameters().size()];
    Arrays.fill(wide, 1);
    Hypothesis free = Hypothesis.NONE;
    for (int round = 0; round < 3; round++) {
      free = new Waves(fitter, form).moved(free, wide);
    }
    assertEquals(0.05, free.values()[0], 0.01);
    double[] tight = new double[wide.length];
    Arrays.fill(tight, 1e-8);
    Hypothesis held = new Waves(fitter, form).moved(Hypothesis.NONE, tight);
    assertEquals(0, held.values()[0], 1e-3);
    // 4 cm at most in a step: what the prior wins is more than what the readings lose.
    Hypothesis back = new Waves(fitter, form).moved(free, tight);
    assertEquals(free.values()[0] - 0.04, back.values()[0], 1e-9);
  }

  /** A reference of which every fourth block of time is silent, and one of independent readings. */
  @Test
  void clumping_isHowMuchMoreBlocksVary() {
    List<ReadingRow> rows = Worlds.read(Worlds.poses(600, 0.3, 1.3, 19), Hypothesis.NONE, 20);
    assertEquals(1, Calibration.of(Worlds.POST, new PingLog(rows)).clumping(), 0.6);
    List<ReadingRow> clumped =
        rows.stream()
            .map(row -> Math.floor(row.timeS() / 2.5) % 4 == 1 ? silent(row) : row)
            .toList();
    Calibration calibration = Calibration.of(Worlds.POST, new PingLog(clumped));
    // 50 pings in a block: all lost in three of twelve, none in nine.
    assertTrue(calibration.clumping() > 4, () -> "clumping " + calibration.clumping());
    assertTrue(Calibration.of(Worlds.POST, new PingLog(rows)).clumping() >= 1);
  }

  private static ReadingRow silent(ReadingRow row) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO);
  }
}
