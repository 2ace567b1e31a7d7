package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.level.LevelDefaults;
import simbad.sonar.level.LevelFigures;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;

/** Where the values of a fit stand, and what is held of them before anything is read. */
class LayoutTest {
  private static final double EXACT = 1e-9;
  private static final SonarSpec SENSOR = LevelWorlds.POST.sensor();

  /** A square: an eighth of 144 bearings, both ends included, are not alike. */
  private static final Believed SQUARE =
      new Believed(LevelWorlds.POST.scene().obstacles().get(0), SENSOR);

  private static final int ORBITS = 19;
  private static final Layout TWO = new Layout(List.of(SQUARE, SQUARE));
  private static final Layout ONE = new Layout(List.of(SQUARE));

  private static Prior prior(SonarSpec sensor, int transducers) {
    return new Prior(ONE, sensor, List.of(SQUARE), transducers);
  }

  private static double deviation(Prior prior, int index) {
    return 1 / Math.sqrt(prior.precision()[index][index]);
  }

  private static SonarSpec stated() {
    LevelFigures figures =
        new LevelFigures(
            OptionalDouble.empty(),
            OptionalDouble.of(1.9),
            OptionalDouble.of(0.7),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.of(0.009),
            Optional.empty(),
            Optional.of(LevelDefaults.RECEIVER_THRESHOLD_DB),
            OptionalDouble.of(2),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty());
    return SENSOR.withLaw(new SensorLaw(Optional.of(SensorLaw.Model.LEVEL), figures));
  }

  /** Two values and eleven of the receiver, the level, the lobes of each, three of the beam. */
  @Test
  void theValuesStandOneAfterTheOther() {
    assertEquals(2 + 11, Layout.LEVEL);
    assertEquals(14, TWO.lobe(0, 0));
    assertEquals(14 + ORBITS, TWO.lobe(1, 0));
    assertEquals(14 + ORBITS + 3, TWO.lobe(1, 3));
    assertEquals(14 + 2 * ORBITS, TWO.aperture());
    assertEquals(15 + 2 * ORBITS, TWO.squint());
    assertEquals(16 + 2 * ORBITS, TWO.scatter());
    assertEquals(17 + 2 * ORBITS, TWO.size());
  }

  /** Figures of docs/method/level-model.md. */
  @Test
  void ofASensorThatStatesNothingPhysicsSaysItsShare() {
    Prior prior = prior(SENSOR, 1);
    double[] mean = prior.mean();

    assertEquals(1.65, mean[0], EXACT);
    assertEquals(0.2, deviation(prior, 0), EXACT);
    assertEquals(SENSOR.levelLaw().absorptionDbPerM(), mean[1], EXACT);
    assertEquals(0.4, deviation(prior, 1), EXACT);
    assertEquals(1, deviation(prior, Layout.LEVEL), EXACT);
    assertEquals(Math.log(LevelForms.APERTURE_M), mean[ONE.aperture()], EXACT);
    assertEquals(0.25, deviation(prior, ONE.aperture()), EXACT);
    assertEquals(Math.toRadians(2), deviation(prior, ONE.squint()), EXACT);
    assertEquals(0, mean[ONE.scatter()], EXACT);
    assertEquals(Math.log(1.35), deviation(prior, ONE.scatter()), EXACT);
    assertEquals(0, mean[Layout.RECEIVER], 0);
    assertEquals(0, mean[ONE.lobe(0, 0)], 0);
  }

  /** Of what is stated a quarter is left open. */
  @Test
  void whatASensorStatesIsKnownFourTimesBetter() {
    Prior prior = prior(stated(), 1);
    double[] mean = prior.mean();

    assertEquals(1.9, mean[0], EXACT);
    assertEquals(0.05, deviation(prior, 0), EXACT);
    assertEquals(0.7, mean[1], EXACT);
    assertEquals(0.1, deviation(prior, 1), EXACT);
    assertEquals(Math.log(0.009), mean[ONE.aperture()], EXACT);
    assertEquals(0.0625, deviation(prior, ONE.aperture()), EXACT);
    assertEquals(Math.log(2), mean[ONE.scatter()], EXACT);
    assertEquals(Math.log(1.35) / 4, deviation(prior, ONE.scatter()), EXACT);
    int receiver = Layout.RECEIVER + 4;
    double open = deviation(prior(SENSOR, 1), receiver);
    assertEquals(open / 4, deviation(prior, receiver), 1e-6);
  }

  /** Transducers that look different ways have no squint in common. */
  @Test
  void ofSeveralTransducersNoSquintIsCommon() {
    assertEquals(Math.toRadians(0.02), deviation(prior(SENSOR, 2), ONE.squint()), EXACT);
  }

  /** Neighbours pull each other the same way: what lies between them is negative. */
  @Test
  void distancesAndBearingsAreTiedToTheirNeighboursOnly() {
    double[][] precision = prior(SENSOR, 1).precision();
    for (int at : new int[] {Layout.RECEIVER + 3, ONE.lobe(0, 5)}) {
      assertTrue(precision[at][at] > 0);
      assertTrue(precision[at][at + 1] < 0, "at " + at);
      assertEquals(precision[at][at + 1], precision[at + 1][at], 1e-6 * precision[at][at]);
    }
    assertEquals(0, precision[Layout.RECEIVER][ONE.lobe(0, 0)], 0);
    assertEquals(0, precision[0][1], 0);
    assertNotEquals(0, precision[ONE.lobe(0, 0)][ONE.lobe(0, 1)]);
  }

  /** One deviation costs half a nat, two cost two; nothing costs nothing. */
  @Test
  void aCostIsHalfTheSquareOfTheDistance() {
    Prior prior = prior(SENSOR, 1);
    double[] values = prior.mean();
    assertEquals(0, prior.cost(values), EXACT);
    values[0] += 0.2;
    assertEquals(0.5, prior.cost(values), EXACT);
    values[Layout.LEVEL] -= 2;
    assertEquals(2.5, prior.cost(values), EXACT);
  }

  /** (1 + sqrt 3) exp(-sqrt 3) at one length. */
  @Test
  void theCorrelationFallsFromOne() {
    assertEquals(1, Prior.matern(0), 0);
    assertEquals(0.4833577, Prior.matern(1), 1e-7);
    assertTrue(Prior.matern(5) < 0.002);
  }

  /** A bearing all round that no other is like keeps its spread; the inverse holds that. */
  @Test
  void whatVariesWithTheBearingHasTheSpreadThatIsAsked() {
    double[][] precision = Prior.smooth(SQUARE.symmetry(), 2);
    double[][] twice = Prior.smooth(SQUARE.symmetry(), 4);
    assertEquals(ORBITS, precision.length);
    for (int i = 0; i < ORBITS; i++) {
      for (int j = 0; j < ORBITS; j++) {
        assertEquals(precision[i][j] / 4, twice[i][j], 1e-6 * Math.abs(precision[i][i]));
      }
    }
    double[][] covariance = new Normal(precision).covariance().getData();
    for (int i = 0; i < ORBITS; i++) {
      assertEquals(4, covariance[i][i], 1e-3);
    }
    // 2.5 degrees apart, 4 degrees the length; images further away count too little to tell.
    assertEquals(4 * Prior.matern(2.5 / 4), covariance[9][10], 0.02);
  }

  /** Without a trial the fit is the prior: its means, and its deviations in the values' units. */
  @Test
  void withoutTrialsTheNamedValuesAreThoseOfThePrior() {
    Prior prior = prior(SENSOR, 1);
    Predictor predictor =
        new Predictor(ONE, SENSOR.levelLaw(), List.of(SQUARE), LevelForms.wavenumberPerM(SENSOR));
    LevelFit fit = new LevelFit(prior, predictor, List.of(), List.of(), 0.02);
    List<Named> named = Named.of(ONE, fit, fit.covariance());

    assertEquals(
        List.of(
            "spreading_exponent",
            "absorption_db_per_m",
            "level_added_db",
            "aperture_radius_m",
            "squint_deg",
            "excess_sd_db"),
        named.stream().map(Named::name).toList());
    assertArrayEquals(
        new double[] {0.2, 0.4, 1, 0.25 * 0.007, 2, Math.log(1.35)},
        named.stream().mapToDouble(Named::deviation).toArray(),
        1e-6);
    assertArrayEquals(
        new double[] {1.65, SENSOR.levelLaw().absorptionDbPerM(), 0, 0.007, 0, 1},
        named.stream().mapToDouble(Named::value).toArray(),
        1e-9);
    assertArrayEquals(prior.mean(), fit.values(), EXACT);
    assertEquals(0, fit.priorCost(), EXACT);
    assertEquals(0.02, fit.missRate(), EXACT);
    assertEquals(-logDeterminant(prior) / 2, fit.evidence(), 1e-6);
  }

  private static double logDeterminant(Prior prior) {
    return Matrices.logDeterminant(
        org.hipparchus.linear.MatrixUtils.createRealMatrix(prior.precision()));
  }

  @Test
  void noNumberIsNoValue() {
    assertThrows(IllegalArgumentException.class, () -> new Named("n", Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new Named("n", 1, Double.NaN));
  }

  /** A uniform figure says nothing of a bearing; an echo comes from 3 cm behind at most. */
  @Test
  void aUniformFigureLeavesEachBearingOpen() {
    double[] known = new double[SQUARE.orbits()];
    Arrays.setAll(known, SQUARE::precision);

    assertArrayEquals(new double[ORBITS], known, 0);
    // 0.3 of 5 cm times the root of 2.
    assertEquals(0.3 * Math.hypot(0.05, 0.05), SQUARE.pathSpreadM(), EXACT);
  }
}
