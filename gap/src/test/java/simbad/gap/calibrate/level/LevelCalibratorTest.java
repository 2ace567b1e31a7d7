package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Form;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** Logs drawn from a known law: what was put in comes out. */
class LevelCalibratorTest {
  private static LevelCalibration calibrate(List<ReadingRow> rows) {
    return new LevelCalibrator(LevelWorlds.POST, new PingLog(rows)).fit(Fold.ALL);
  }

  private static Named value(LevelCalibration calibration, String name) {
    return calibration.values().stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @ParameterizedTest
  @ValueSource(longs = {3, 17, 28})
  void valuesLieWithinThreeDeviations(long seed) {
    LevelCalibration values = calibrate(LevelWorlds.log(2000, seed));

    assertWithin(values, "spreading_exponent", LevelWorlds.SPREADING);
    assertWithin(values, "absorption_db_per_m", LevelWorlds.ABSORPTION);
    assertWithin(values, "aperture_radius_m", LevelWorlds.APERTURE_M);
    assertWithin(values, "squint_deg", LevelWorlds.SQUINT_DEG);
    // The lobes take up some of the scatter, so that it comes out small.
    double scatter = value(values, "excess_sd_db").value();
    assertBetween(0.5 * LevelWorlds.SCATTER_DB, 1.3 * LevelWorlds.SCATTER_DB, scatter);
  }

  private static void assertWithin(LevelCalibration values, String name, double truth) {
    Named found = value(values, name);
    assertTrue(Math.abs(found.value() - truth) < 3 * found.deviation(), found.toString());
  }

  /** What the reference can tell: a beam to a tenth, a squint to half a degree. */
  @Test
  void whatManyRowsShowIsKnownBetterThanBefore() {
    LevelCalibration values = calibrate(LevelWorlds.log(2000, 3));

    assertTrue(value(values, "aperture_radius_m").deviation() < 0.1 * 0.008);
    assertTrue(value(values, "squint_deg").deviation() < 0.5);
  }

  /** The scene's thresholds are alike all round; the lobes come from the reference. */
  @Test
  void lobesAreFoundWithinTheirDeviations() {
    Hypothesis calibrated = calibrate(LevelWorlds.log(2000, 5)).setup();
    double[] found = LevelWorlds.strengths(calibrated);
    double[] deviation =
        Arrays.copyOfRange(calibrated.valuesOf(1), LevelForms.BEARINGS, 2 * LevelForms.BEARINGS);
    LevelRule rule = (LevelRule) calibrated.changes().get(0);
    double mean = Arrays.stream(found).average().orElseThrow();

    int within = 0;
    double swing = 0;
    for (int i = 0; i < found.length; i++) {
      double lobe = Math.cos(4 * i * 2 * Math.PI / LevelForms.BEARINGS);
      swing += 2 * lobe * found[i] / found.length;
      within += Math.abs(found[i] - mean - LevelWorlds.LOBES_DB * lobe) < 3 * deviation[i] ? 1 : 0;
    }
    assertTrue(rule.law().excessSdDb() > 0);
    assertBetween(0.6 * LevelWorlds.LOBES_DB, 1.2 * LevelWorlds.LOBES_DB, swing);
    assertTrue(within > (int) (0.9 * LevelForms.BEARINGS));
  }

  /** Echoes from behind the nearest point, by a centimetre four times round, in warmer air. */
  @Test
  void whereEchoesComeFromIsFoundByBearing_andTheAirApartFromIt() {
    Form path = LevelForms.path("post");
    double[] added = path.neutral();
    for (int i = 0; i < LevelForms.BEARINGS; i++) {
      added[i] = 0.01 * Math.cos(4 * i * 2 * Math.PI / LevelForms.BEARINGS);
    }
    Hypothesis lawAndLobes = LevelWorlds.truth();
    double[] law = lawAndLobes.valuesOf(0);
    law[law.length - 1] = 1.008;
    Hypothesis truth =
        Hypothesis.NONE
            .and(lawAndLobes.forms().get(0), law)
            .and(lawAndLobes.forms().get(1), lawAndLobes.valuesOf(1))
            .and(path, added);
    List<ReadingRow> rows = Worlds.read(LevelWorlds.POST, LevelWorlds.poses(2500, 8), truth, 9);

    Hypothesis found = calibrate(rows).setup();
    double[] paths = found.valuesOf(2);
    double swing = 0;
    for (int i = 0; i < LevelForms.BEARINGS; i++) {
      swing += 2 * 100 * added[i] * paths[i] / LevelForms.BEARINGS;
    }
    assertBetween(0.007, 0.0115, swing);
    // Far echoes are weak ones: a part of the air's share is taken for walk. Together they fit.
    double[] values = found.valuesOf(0);
    assertBetween(1.001, 1.01, values[values.length - 1]);
    PingLog fresh =
        new PingLog(Worlds.read(LevelWorlds.POST, LevelWorlds.poses(1500, 80), truth, 81));
    double most = nats(truth, fresh);
    assertTrue(most - nats(found, fresh) < 0.15 * (most - nats(Hypothesis.NONE, fresh)));
    assertTrue(paths[LevelForms.BEARINGS] > 0);
  }

  /** Under 28 cm echoes read short by up to two centimetres, whatever their level. */
  @Test
  void whatIsReadShortNearBy_isFoundApartFromTheWalk() {
    double[] near = {-0.02, -0.018, -0.012, -0.004};
    Hypothesis truth = LevelWorlds.truth().and(LevelForms.nearRange(), near);
    List<ReadingRow> rows = Worlds.read(LevelWorlds.POST, nearPoses(1500, 8), truth, 9);
    rows =
        Stream.concat(
                rows.stream(), LevelWorlds.log(1000, 5).stream().map(LevelCalibratorTest::later))
            .toList();

    double[] found = nearRange(calibrate(rows));
    assertBetween(-0.023, -0.014, found[1]);
    assertBetween(-0.016, -0.008, found[2]);
    double[] none = nearRange(calibrate(LevelWorlds.log(2000, 3)));
    assertTrue(Arrays.stream(none).allMatch(added -> Math.abs(added) < 0.004));
  }

  private static ReadingRow later(ReadingRow row) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS() + 1000, row.pose(), row.reading());
  }

  private static List<ReadingRow> nearPoses(int count, long seed) {
    return LevelWorlds.poses(count, seed).stream()
        .map(row -> row.at(nearer(row.pose()), row.circumstances()))
        .toList();
  }

  private static Pose nearer(Pose pose) {
    double share = 0.2;
    return Pose.of(
        share * pose.position().xM(), share * pose.position().zM(), pose.heading().radians());
  }

  private static double[] nearRange(LevelCalibration calibration) {
    Hypothesis setup = calibration.setup();
    for (int i = 0; i < setup.forms().size(); i++) {
      if (setup.forms().get(i).equals(LevelForms.nearRange())) {
        return setup.valuesOf(i);
      }
    }
    throw new AssertionError("no form of near ranges");
  }

  /** A data sheet said 60 to 100 cm; the post was heard from 30 cm to beyond 2 m. */
  @Test
  void whatWasHeardBeyondItsLimits_movesThem() {
    SensingSetup sheet =
        new SensingSetup(LevelWorlds.POST.sensor().withRange(0.6, 1), LevelWorlds.POST.scene(), 4);
    List<ReadingRow> rows = LevelWorlds.log(1500, 21);
    LevelRule rule =
        (LevelRule)
            new LevelCalibrator(sheet, new PingLog(rows)).fit(Fold.ALL).setup().changes().get(0);

    assertBetween(0.2, 0.4, rule.minRangeM());
    assertBetween(1.5, 3, rule.maxRangeM());
    LevelRule kept = (LevelRule) calibrate(rows).setup().changes().get(0);
    assertEquals(LevelWorlds.POST.sensor().minRangeM(), kept.minRangeM(), 0);
    assertEquals(LevelWorlds.POST.sensor().maxRangeM(), kept.maxRangeM(), 0);
  }

  @Test
  void aFreshLogIsForetoldNearlyAsByTheTruth() {
    Hypothesis calibrated = calibrate(LevelWorlds.log(1500, 7)).setup();
    PingLog fresh = new PingLog(LevelWorlds.log(1500, 99));

    double nominal = nats(Hypothesis.NONE, fresh);
    double truth = nats(LevelWorlds.truth(), fresh);
    assertTrue(truth - nats(calibrated, fresh) < 0.15 * (truth - nominal));
  }

  private static double nats(Hypothesis hypothesis, PingLog log) {
    CalibratedLog given = new CalibratedLog(LevelWorlds.POST, hypothesis.changes(), log);
    return Arrays.stream(given.logLikelihood(Hypothesis.NONE)).sum();
  }

  @Test
  void theSameLogGivesTheSameBits() {
    List<ReadingRow> rows = LevelWorlds.log(400, 11);

    assertEquals(calibrate(rows).setup(), calibrate(rows).setup());
  }

  /** Without a reading the thresholds are what the scene says. */
  @Test
  void nothingReadLeavesTheSceneAsItIs() {
    LevelCalibration calibration =
        new LevelCalibrator(LevelWorlds.POST, new PingLog(LevelWorlds.log(50, 2)))
            .fit(ping -> false);
    LevelRule rule = (LevelRule) calibration.setup().changes().get(0);
    double strength = LevelWorlds.strengths(calibration.setup())[10];

    assertEquals(0, calibration.trials());
    assertBetween(1.3, 1.7, rule.law().firstLossM(strength, 4));
  }

  private static void assertBetween(double low, double high, double value) {
    assertTrue(value >= low && value <= high, value + " is not in [" + low + ", " + high + "]");
  }
}
