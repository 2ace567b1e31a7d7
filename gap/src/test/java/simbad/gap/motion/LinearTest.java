package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

class LinearTest {
  private static final int STEPS = 1500;
  private static final MotionSteps GIVEN = given();
  private static final Noise HEAVY = new Noise(1e-4, 1, 3);

  private static MotionSteps given() {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= STEPS; i++) {
      track.add(new TrackPose(0.2 * i, 0, 0, 0));
    }
    return new MotionSteps(List.of(new MotionRun("a", List.of(new Command(0, 1, 0)), track)));
  }

  /** Student's t with three degrees of freedom, by the square root of 0.2 s at a load of 1.05. */
  private static double[] heavy(SplittableRandom random) {
    double[] values = new double[STEPS];
    for (int i = 0; i < STEPS; i++) {
      double square = 0;
      for (int k = 0; k < 3; k++) {
        square += Math.pow(random.nextGaussian(), 2) / 3;
      }
      values[i] = Math.sqrt(0.21) * random.nextGaussian() / Math.sqrt(square);
    }
    return values;
  }

  private static Linear about(double[] residuals, double mean) {
    double[] off = Arrays.stream(residuals).map(r -> r - mean).toArray();
    double[] zeros = new double[STEPS];
    double[] ones = new double[STEPS];
    Arrays.fill(ones, 1);
    Whitening[] white = {
      new Whitening(GIVEN, HEAVY, off),
      new Whitening(GIVEN, HEAVY, zeros),
      new Whitening(GIVEN, HEAVY, zeros)
    };
    return new Linear(GIVEN, white, new double[][][] {{white[0].of(ones), zeros, zeros}});
  }

  /** Returns the mean that fits best. */
  private static double fitted(double[] residuals) {
    double mean = 0;
    for (int round = 0; round < 8; round++) {
      mean += about(residuals, mean).move(block -> true, 0)[0];
    }
    return mean;
  }

  /** Over 200 logs the estimates scatter as their standard errors say. False alarms: under 1 %. */
  @Test
  void standardErrors_areThoseOfHeavyTails() {
    SplittableRandom random = new SplittableRandom(31);
    double square = 0;
    for (int log = 0; log < 200; log++) {
      double[] residuals = heavy(random);
      double mean = fitted(residuals);
      double z = mean / about(residuals, mean).standardErrors()[0];
      square += z * z / 200;
    }
    // What wanders by chance makes errors a little larger, never smaller.
    assertEquals(0.92, Math.sqrt(square), 0.13);
  }

  /** One step goes nearly all the way to where many go. */
  @Test
  void oneStep_isEnough() {
    double[] residuals = heavy(new SplittableRandom(32));
    double[] moved = Arrays.stream(residuals).map(r -> r + 0.05).toArray();
    assertEquals(fitted(moved), about(moved, 0).move(block -> true, 0)[0], 0.005);
  }

  /**
   * Scatter that stays for a second makes sums scatter more; what stays for a minute has a cause.
   */
  @Test
  void whatLastsASecond_isKnownFromWhatLastsAMinute() {
    double[] residuals = heavy(new SplittableRandom(34));
    double[] lasting = new double[STEPS];
    double[] drifting = new double[STEPS];
    for (int i = 0; i < STEPS; i++) {
      lasting[i] = (i < 5 ? 0 : 0.8 * lasting[i - 1]) + residuals[i];
      drifting[i] = residuals[i] + (i / 300 % 2 == 0 ? 0.3 : -0.3);
    }
    double white = about(residuals, fitted(residuals)).lasting();
    assertTrue(white < 1.6, "white " + white);
    assertTrue(about(lasting, fitted(lasting)).lasting() > 3, "lasting");
    assertTrue(about(drifting, fitted(drifting)).lasting() < 2, "drifting");
  }

  /** What is a little more for half a minute and a little less for the next is known less well. */
  @Test
  void whatWanders_isKnownLessWell() {
    double[] residuals = heavy(new SplittableRandom(33));
    double[] wandering = new double[STEPS];
    Arrays.setAll(wandering, i -> residuals[i] + (i / 150 % 2 == 0 ? 0.06 : -0.06));
    Linear steady = about(residuals, fitted(residuals));
    Linear wanders = about(wandering, fitted(wandering));
    assertTrue(wanders.clumping() > 3 * steady.clumping(), "clumping " + wanders.clumping());
    assertTrue(wanders.drift(0).square() > 2 * 9, "wanders " + wanders.drift(0));
    assertEquals(9, steady.drift(0).freedoms());
    assertTrue(steady.drift(0).square() < 2.5 * 9, "steady " + steady.drift(0));
    assertTrue(wanders.standardErrors()[0] > 1.7 * steady.standardErrors()[0], "error");
  }

  /** A value that one block alone tells is without it what was believed, not anything. */
  @Test
  void whatOneBlockTells_isWithoutItAsBelieved() {
    double[] once = new double[STEPS];
    Arrays.fill(once, 0, 3, 1);
    double[] zeros = new double[STEPS];
    double[] residuals = heavy(new SplittableRandom(35));
    Whitening[] white = {
      new Whitening(GIVEN, HEAVY, residuals),
      new Whitening(GIVEN, HEAVY, zeros),
      new Whitening(GIVEN, HEAVY, zeros)
    };
    double[][][] columns = {{white[0].of(once), zeros, zeros}};
    double[] precisions = {1 / 0.04};
    double[] moves = {-0.3};
    Linear linear = new Linear(GIVEN, white, columns, new Linear.Belief(precisions, moves));
    for (int fold = 0; fold < MotionSteps.FOLDS; fold++) {
      double by = linear.withoutFold(fold)[0];
      assertEquals(fold == GIVEN.foldOf(0) ? -0.3 : 0, by, fold == GIVEN.foldOf(0) ? 1e-6 : 0.3);
    }
  }
}
