package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.scene.SonarSpec;

/** What echoes read of their distances: knots and weights by hand, and fits of known ranges. */
class RangesTest {
  private static final double EXACT = 1e-12;
  private static final double[] NOTHING = {};
  private static final List<Double> WALK = LevelForms.WALK_DB;
  private static final SonarSpec SENSOR = LevelWorlds.POST.sensor();
  private static final Believed POST =
      new Believed(LevelWorlds.POST.scene().obstacles().get(0), SENSOR);
  private static final double PATH_M = 0.3 * Math.hypot(0.05, 0.05);

  /** Knots at 0, 4, 8, 14 and 24 dB. */
  @Test
  void knotsCountStraightBetweenThemAndAlikeBeyond() {
    assertArrayEquals(new double[] {1, 0, 0, 0, 0}, RangeFit.weights(WALK, -1), EXACT);
    assertArrayEquals(new double[] {0.75, 0.25, 0, 0, 0}, RangeFit.weights(WALK, 1), EXACT);
    assertArrayEquals(new double[] {0, 1, 0, 0, 0}, RangeFit.weights(WALK, 4), EXACT);
    assertArrayEquals(new double[] {0, 0, 0.5, 0.5, 0}, RangeFit.weights(WALK, 11), EXACT);
    assertArrayEquals(new double[] {0, 0, 0, 0.9, 0.1}, RangeFit.weights(WALK, 15), EXACT);
    assertArrayEquals(new double[] {0, 0, 0, 0, 1}, RangeFit.weights(WALK, 30), EXACT);
  }

  @Test
  void productsReachAsFarAsTheFirst() {
    assertEquals(14, RangeFit.dot(new double[] {2, 3}, new double[] {1, 4, 9}), EXACT);
  }

  /** Student's of four degrees: (4 + 1) / (4 + deviations squared), over the variance. */
  @Test
  void whatLiesFarOffCountsLess() {
    assertEquals(1.25 / 0.04, RangeFit.weight(0, 0.04), EXACT);
    assertEquals(1 / 0.04, RangeFit.weight(0.2, 0.04), 1e-9);
    assertEquals(0.5 / 0.04, RangeFit.weight(-0.2 * Math.sqrt(6), 0.04), 1e-9);
  }

  /** 3 cm at each knot, 1 cm from one to the next. */
  @Test
  void beforeAReadingTheWalkIsNothingAndEven() {
    double[][] prior = RangeFit.prior();
    double own = 1 / 0.0009;

    assertArrayEquals(new double[] {own + 1e4, -1e4, 0, 0, 0}, prior[0], 1e-6);
    assertArrayEquals(new double[] {0, -1e4, own + 2e4, -1e4, 0}, prior[2], 1e-6);
    assertArrayEquals(new double[] {0, 0, 0, -1e4, own + 1e4}, prior[4], 1e-6);
  }

  /** Rounding to 1 cm is 1/12 of a square centimetre. */
  @Test
  void aVarianceIsThatOfNoiseAndSteps() {
    RangeFit fit = new RangeFit(NOTHING, NOTHING, 0.01, 0.005);

    assertEquals(25e-6 + 1e-4 / 12, fit.variance(5), 1e-11);
    assertArrayEquals(
        new double[] {25e-6 + 1e-4 / 12, 25e-6 + 1e-4 / 12},
        fit.variances(new double[] {-3, 40}),
        1e-11);
    assertEquals(5e-4, new RangeFit(NOTHING, NOTHING, 0, 0).noiseM()[1], EXACT);
  }

  /** Six echoes at 8 dB, 5 mm to either side, beside a belief of 5 mm that is worth six. */
  @Test
  void noiseIsThatOfBeliefAndEchoesTogether() {
    double[] excess = {8, 8, 8, 8, 8, 8};
    double[] beyond = {0.005, -0.005, 0.005, -0.005, 0.005, -0.005};
    double[] noise = new RangeFit(excess, beyond, 0, 0.005).noiseM();

    assertEquals(0.005 * Math.sqrt((6 + 6 / 0.96) / 12), noise[1], 1e-9);
    assertEquals(0.005, noise[0], 1e-9);
    assertEquals(0.005, noise[2], 1e-9);
  }

  /** The greatest step of any knot; what is left is less the walk. */
  @Test
  void aWalkIsTakenAsItIsGiven() {
    RangeFit fit = new RangeFit(new double[] {2}, new double[] {0}, 0, 0.005);
    double[] walk = {0.01, 0.03, 0, -0.02, 0};
    double moved = fit.take(walk, new double[] {0.02});

    assertEquals(0.03, moved, 1e-6);
    assertArrayEquals(walk, fit.walkM(), 0);
    assertEquals(0.02, fit.walkM(2), EXACT);
    assertEquals(-0.02, fit.walkM(14), EXACT);
    assertArrayEquals(
        new double[] {0.08, 0.12},
        fit.beyond(new double[] {2, 14}, new double[] {0.1, 0.1}),
        EXACT);
    // The echo lies on the walk: it only makes the noise less.
    assertEquals(0.005 * Math.sqrt(6 / 7.0), fit.noiseM()[0], 1e-9);
    assertEquals(0.03, fit.take(new double[5], new double[] {0}), 1e-6);
  }

  /** 0.12 m is half way between two knots near by; from 0.4 m on none counts. */
  @Test
  void anEchoSaysSomethingOfShareWalkAndWhatIsNear() {
    assertArrayEquals(
        new double[] {0.12, 0.5, 0.5, 0, 0, 0, 0.5, 0.5, 0, 0}, Ranges.row(0.12, 2), EXACT);
    assertArrayEquals(
        new double[] {0.34, 0, 0, 0, 0, 1, 0, 0, 0, 0.5}, Ranges.row(0.34, 50), EXACT);
    assertArrayEquals(new double[] {2, 1, 0, 0, 0, 0, 0, 0, 0, 0}, Ranges.row(2, -5), EXACT);
  }

  private static Ranges ranges(int targets, List<Trials.Trial> trials) {
    List<Believed> all = Collections.nCopies(targets, POST);
    return Ranges.of(LevelPosts.predictor(all), trials, all, SENSOR);
  }

  /**
   * Half a per cent of the air's share, and a walk from 0 at 0.4 m by 3 mm from knot to knot: so
   * many times 9 mm² at the first ones.
   */
  @Test
  void withoutEchoesNothingIsAddedAndThePriorIsLeft() {
    Ranges none = ranges(1, List.of());

    assertEquals(1, none.scale(), EXACT);
    assertArrayEquals(new double[4], none.nearM(), EXACT);
    assertEquals(25e-6, none.covariance().getEntry(0, 0), 1e-10);
    for (int i = 0; i < 4; i++) {
      assertEquals((4 - i) * 9e-6, none.covariance().getEntry(6 + i, 6 + i), 1e-10);
    }
    double[] path = none.byBearing().get(0).values();
    assertEquals(0, path[0], EXACT);
    assertEquals(PATH_M, path[LevelForms.BEARINGS], 1e-4);
  }

  /** Read 2 mm long for each metre, by 1 cm with the bearing, and by up to 12 mm short near by. */
  private static double truth(double bearing, double nearest) {
    double near = Math.max(0, Math.min(1, (0.4 - nearest) / 0.3));
    return 0.002 * nearest + 0.01 * Math.cos(4 * bearing) - 0.012 * near;
  }

  private static List<Trials.Trial> grid(int target) {
    List<Trials.Trial> all = new ArrayList<>();
    double[] distances = {0.12, 0.17, 0.25, 0.33, 0.5, 0.9, 1.4, 2, 2.6};
    for (int i = 0; i < LevelForms.BEARINGS; i++) {
      for (double nearest : distances) {
        double bearing = (i + 0.3) * 2 * Math.PI / LevelForms.BEARINGS;
        double beyond = truth(bearing, nearest);
        int ping = all.size();
        all.add(
            new Trials.Trial(
                ping, target, bearing, nearest + 0.05, nearest, 0, true, 0, 1, beyond));
      }
    }
    return all;
  }

  private static double foretold(Ranges found, Predictor predictor, Trials.Trial trial) {
    double excess = predictor.excess(predictor.row(trial)).decibels();
    return (found.scale() - 1) * trial.nearestM()
        + found.byLevel().walkM(excess)
        + RangeFit.dot(found.nearM(), RangeFit.weights(LevelForms.NEAR_M, trial.nearestM()))
        + found.byBearing().get(trial.target()).at(trial);
  }

  /** Apart they cannot be told in every part; together they are what was read. */
  @Test
  void shareBearingAndNearnessAreFoundTogether() {
    List<Trials.Trial> trials = grid(0);
    Ranges found = ranges(1, trials);
    Predictor predictor = LevelPosts.predictor(List.of(POST));
    for (Trials.Trial trial : trials) {
      assertEquals(trial.beyondM(), foretold(found, predictor, trial), 8e-4, trial.toString());
    }
    double[] path = found.byBearing().get(0).values();
    // Faces are at 0 and 90 degrees, edges at 45: 18 bearings of 2.5 degrees on.
    assertEquals(0.02, path[0] - path[18], 1e-3);
    assertEquals(0.02, path[36] - path[54], 1e-3);
    double known = path[LevelForms.BEARINGS];
    assertTrue(known > 0 && known < 0.1 * PATH_M, () -> "known to " + known);
  }

  /** Of two alike posts only the second was read: nothing is known of the first. */
  @Test
  void whatWasNotReadIsNotKnown() {
    List<Trials.Trial> trials = new ArrayList<>(grid(1));
    trials.add(new Trials.Trial(9999, 0, 1, 1.05, 1, 0, false, 0, 1, 5));
    Ranges found = ranges(2, trials);
    double[] first = found.byBearing().get(0).values();
    double[] second = found.byBearing().get(1).values();

    assertEquals(0, Arrays.stream(first, 0, LevelForms.BEARINGS).map(Math::abs).sum(), EXACT);
    assertEquals(PATH_M, first[LevelForms.BEARINGS], 1e-4);
    assertEquals(0.02, second[0] - second[18], 1e-3);
  }
}
