package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/** How steps scatter: what a tracker and a robot add, and noises that are found again. */
class NoiseTest {
  private static final double EXACT = 1e-12;

  /** A robot that is told to go 20 cm/s and to turn by half a radian in a second. */
  private static MotionSteps given(int steps) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      track.add(new TrackPose(0.2 * i, 0, 0, 0));
    }
    return new MotionSteps(List.of(new MotionRun("a", List.of(new Command(0, 0.2, 0.5)), track)));
  }

  /** Both ends are off by the tracker; Student's t of four degrees is twice as broad. */
  @Test
  void aVarianceIsThatOfBothEndsAndOfTheWay() {
    assertEquals(2 * 0.09 + 2 * 0.25 * 3 * 0.5, new Noise(0.3, 0.5, 4).variance(0.5, 3), EXACT);
    assertEquals(2 * 0.09 + 3 * 0.25, new Noise(0.3, 0.5, 2).variance(1, 1), EXACT);
    assertEquals(2 * 0.09, new Noise(0.3, 0.5, 4).variance(0, 3), EXACT);
  }

  /** Files have so many digits. */
  @Test
  void noTrackerIsBetterThanItsFile() {
    assertEquals(new Noise(2e-5, 0, 60), Noise.believed(0));
    assertEquals(new Noise(0.01, 0, 60), Noise.believed(0.01));
    assertEquals(new Noise(0.02, 0.02, 8), Noise.start(0.04));
    assertEquals(new Noise(2e-5, 2e-5, 8), Noise.start(1e-6));
    assertEquals(2e-5, new Noise(1, 1, 5).withLogs(new double[] {-50, 0}).tracker(), 0);
  }

  @Test
  void logarithmsThereAndBackAreTheSame() {
    Noise noise = new Noise(0.03, 0.2, 5);
    assertArrayEquals(new double[] {Math.log(0.03), Math.log(0.2)}, noise.logs(), EXACT);
    Noise back = noise.withLogs(noise.logs());
    assertEquals(0.03, back.tracker(), EXACT);
    assertEquals(0.2, back.process(), EXACT);
    assertEquals(5, back.freedom(), 0);
    assertEquals(new Noise(0.03, 0.2, 3), noise.withFreedom(3));
    // Where the robot scatters by nothing, a thousandth of the tracker stands for it.
    assertEquals(Math.log(0.03e-3), new Noise(0.03, 0, 5).logs()[1], EXACT);
  }

  /** Errors of both ends: the next step takes back what the one before had too much. */
  @Test
  void aTrackersNoiseIsFoundAsSuch() {
    Random random = new Random(3);
    double[] residuals = new double[800];
    double before = 0.01 * random.nextGaussian();
    for (int i = 0; i < residuals.length; i++) {
      double after = 0.01 * random.nextGaussian();
      residuals[i] = after - before;
      before = after;
    }
    Noise found = afresh(residuals);

    assertEquals(0.01, found.tracker(), 0.0012);
    assertTrue(found.process() * Math.sqrt(0.2) < 0.003, () -> found.toString());
  }

  /** What the robot itself scatters by grows with the square root of the time. */
  @Test
  void aRobotsNoiseIsFoundAsSuch() {
    MotionSteps given = given(800);
    Noise found = afresh(scattered(given, 0.05, false));

    assertEquals(0.05, found.process(), 0.006);
    assertTrue(found.tracker() < 0.006, () -> found.toString());
    assertTrue(found.freedom() >= 10, () -> found.toString());
  }

  /** One step in ten is four times as far off. */
  @Test
  void whatIsFarOffNowAndThenIsStudents() {
    Noise found = afresh(scattered(given(800), 0.05, true));

    assertTrue(found.freedom() <= 5, () -> found.toString());
  }

  private static double[] scattered(MotionSteps given, double process, boolean heavy) {
    Random random = new Random(4);
    double[] residuals = new double[given.size()];
    for (int i = 0; i < residuals.length; i++) {
      double times = heavy && i % 10 == 0 ? 4 : 1;
      residuals[i] = times * process * Math.sqrt(given.loads()[i] * 0.2) * random.nextGaussian();
    }
    return residuals;
  }

  private static Noise afresh(double[] residuals) {
    return NoiseFit.afresh(given(residuals.length), new double[][] {residuals})[0];
  }

  /** Nothing that is near makes the residuals likelier than what was found. */
  @Test
  void theLikeliestIsNearlyTheTop() {
    MotionSteps given = given(400);
    double[] residuals = scattered(given, 0.05, false);
    double most = NoiseFit.likeliest(given, given.loads(), residuals);
    Noise found = NoiseFit.afresh(given, new double[][] {residuals})[0];
    assertEquals(density(given, found, residuals), most, 1e-9);
    // The last step of the search is an eighth of a logarithm.
    for (double[] by : new double[][] {{0.125, 0}, {-0.125, 0}, {0, 0.125}, {0, -0.125}}) {
      double[] logs = {found.logs()[0] + by[0], found.logs()[1] + by[1]};
      assertTrue(density(given, found.withLogs(logs), residuals) <= most + 1e-6);
    }
    assertTrue(most > density(given, new Noise(1e-4, 0.05, 3), residuals));
    // From a noise that is a little off it comes nearly as high, the shape unchanged: its last step
    // is 0.15.
    Noise off = new Noise(found.tracker(), 0.03, found.freedom());
    Noise near = NoiseFit.near(given, new double[][] {residuals}, new Noise[] {off})[0];
    assertEquals(most, density(given, near, residuals), 400 * 0.075 * 0.075);
    assertTrue(density(given, near, residuals) > density(given, off, residuals) + 10);
    assertEquals(found.freedom(), near.freedom(), 0);
  }

  private static double density(MotionSteps given, Noise noise, double[] residuals) {
    return Whitening.logDensity(given, given.loads(), noise, residuals);
  }

  @Test
  void logarithmsOfProductsAreSums() {
    LogProduct small = new LogProduct();
    LogProduct large = new LogProduct();
    for (int i = 0; i < 1000; i++) {
      small.times(1e-3);
      large.times(2e5);
    }

    assertEquals(0, new LogProduct().log(), 0);
    assertEquals(1000 * Math.log(1e-3), small.log(), 1e-6);
    assertEquals(1000 * Math.log(2e5), large.log(), 1e-6);
  }

  /**
   * In half a second it goes 10 cm, less what a step's turn takes from going straight on, and turns
   * by a quarter radian. Gaussian is 60 degrees of Student's t.
   */
  @Test
  void scatterIsAShareOfWhatIsDone() {
    MotionSteps given = given(40);
    Noise[] believed = {Noise.believed(0.001), Noise.believed(0.001), Noise.believed(0.002)};
    Noise[] found = {new Noise(0.001, 0.02, 60), believed[1], new Noise(0.002, 0.1, 60)};
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    MotionFit fit = new MotionFit(none, given.residuals(MotionChain.EXACT), found, 0);
    Scatter scatter = Scatter.of(given, fit, believed);
    double heavy = Math.sqrt(60 / 58.0 * 0.5);
    double way = 0.1 * Math.sin(0.1) / 0.1;

    assertEquals(heavy * 0.02 / way, scatter.along(), 1e-4);
    assertEquals(heavy * 0.1 / 0.25, scatter.turn(), 1e-6);
    assertTrue(scatter.seesAlong() && scatter.seesTurn());
    Scatter none2 = Scatter.of(given, new MotionFit(none, fit.residuals(), believed, 0), believed);
    assertEquals(0, none2.greatest(), 0);
    assertFalse(none2.seesAlong() || none2.seesTurn());
  }

  @Test
  void whatScattersByAFiftiethMatters() {
    assertTrue(new Scatter(0.02, 0, false, false).matters());
    assertTrue(new Scatter(0, 0.03, false, false).matters());
    assertFalse(new Scatter(0.0199, 0.01, true, true).matters());
    assertEquals(0.3, new Scatter(0.1, 0.3, true, true).greatest(), 0);
  }

  /** Less than three tenths of the other, where that would be seen. */
  @Test
  void scatterMayBeOneSided() {
    assertTrue(new Scatter(0.1, 0.029, false, true).isOneSided());
    assertTrue(new Scatter(0.029, 0.1, true, false).isOneSided());
    assertFalse(new Scatter(0.1, 0.031, true, true).isOneSided());
    assertFalse(new Scatter(0.031, 0.1, true, true).isOneSided());
    assertFalse(new Scatter(0.1, 0.029, true, false).isOneSided());
    assertFalse(new Scatter(0.029, 0.1, false, true).isOneSided());
    assertFalse(new Scatter(0.01, 0, true, true).isOneSided());
  }

  @Test
  void noChanceIsCertain() {
    assertEquals(1 - 1e-6, NormalChance.below(20), 0);
    assertEquals(1 - 1e-6, NormalChance.ofLogOdds(90), 0);
    assertEquals(0, NormalChance.ofLogOdds(-90), 1e-12);
    assertEquals(0.6745, NormalChance.deviate(0.75), 1e-4);
    assertEquals(-NormalChance.deviate(0.975), NormalChance.deviate(0.025), 1e-9);
    assertEquals(0, NormalChance.deviate(0.5), EXACT);
  }
}
