package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/**
 * Drives straight on at speeds that change, seen exactly: what a scale changes is the way itself.
 */
class SlopesTest {
  private static final double EXACT = 1e-6;

  /** (nu + 3) / (nu + 1) of noise that is practically Gaussian. */
  private static final double STEP = 63 / 61.0;

  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final MotionForm STEPS = MotionForms.find("command-quantization").orElseThrow();
  private static final MotionForm LIMIT = MotionForms.find("saturation: speed").orElseThrow();
  private static final MotionForm BIAS = MotionForms.find("turn-bias").orElseThrow();
  private static final Noise[] NOISES = {
    new Noise(1e-6, 0.01, 60), new Noise(1e-6, 0.01, 60), new Noise(1e-6, 0.01, 60)
  };

  private static List<Command> commands() {
    List<Command> commands = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      commands.add(new Command(2 * i, 0.1 + 0.05 * (i % 4), 0));
    }
    return commands;
  }

  /**
   * Six blocks, which go so many times as fast as they are told; the last is left out with none.
   */
  private static MotionSteps given(double first, double others) {
    List<Command> commands = commands();
    List<TrackPose> track = new ArrayList<>();
    double x = 0;
    for (int i = 0; i <= 300; i++) {
      track.add(new TrackPose(i / 5.0, x, 0, 0));
      boolean early = i % 250 < 50;
      x += (early ? first : others) * commands.get(Math.min(29, i / 10)).speedMPerS() / 5;
    }
    return new MotionSteps(List.of(new MotionRun("a", commands, track)));
  }

  private static MotionHypothesis set(MotionForm form, double... values) {
    return new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]).with(form, values);
  }

  private static MotionFit fit(MotionSteps given, MotionHypothesis set) {
    return new MotionFit(set, given.residuals(set.chain()), NOISES, 0);
  }

  /** By a unit of the factor a residual falls by the way that is told. */
  @Test
  void aColumnIsWhatAUnitChanges() {
    MotionSteps given = given(1.2, 1.2);
    Slopes slopes = new Slopes(given, fit(given, set(SCALE, 1)));
    double[][] told = given.expected(MotionChain.EXACT);

    assertEquals(1, slopes.raw().length);
    assertArrayEquals(told[0], slopes.raw()[0][0], EXACT);
    assertArrayEquals(new double[300], slopes.raw()[0][2], EXACT);
    for (int c = 0; c < 3; c++) {
      assertArrayEquals(slopes.white()[c].of(slopes.raw()[0][c]), slopes.columns()[0][c], 1e-12);
    }
    assertFalse(slopes.isEmpty());
    // At the greatest factor that is allowed it is told from below.
    Slopes most = new Slopes(given, fit(given, set(SCALE, 5)));
    assertArrayEquals(told[0], most.raw()[0][0], EXACT);
  }

  /** A turn by itself goes with time, and counts the short way round. */
  @Test
  void turnsAreToldTheShortWayRound() {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 20; i++) {
      track.add(new TrackPose(i / 5.0, 0, 0, 0));
    }
    MotionSteps given = new MotionSteps(List.of(new MotionRun("a", List.of(Command.STAND), track)));
    double almost = Math.PI - 0.0001;
    double[][] residuals = new double[3][20];
    Arrays.fill(residuals[2], almost);
    MotionFit fit = new MotionFit(set(BIAS, 0), residuals, NOISES, 0);
    double probe = BIAS.parameters().get(0).probe();
    // Nothing was seen: what is moved goes by the probe's turn beside the residual that is said.
    double by = almost + probe / 5;
    double wrapped = by > Math.PI ? by - 2 * Math.PI : by;

    assertEquals(wrapped / probe, new Slopes(given, fit).raw()[0][2][7], EXACT);
  }

  @Test
  void whatJumpsOrIsInfiniteIsNotFree() {
    MotionSteps given = given(1, 1);
    Slopes steps = new Slopes(given, fit(given, set(STEPS, 0.05, 0)));
    assertTrue(steps.isEmpty());
    assertArrayEquals(new double[2], steps.standardErrors(), 0);
    assertTrue(new Slopes(given, fit(given, set(LIMIT, Double.POSITIVE_INFINITY))).isEmpty());

    MotionHypothesis both = set(STEPS, 0.05, 0).with(SCALE, new double[] {1});
    Slopes beside = new Slopes(given, fit(given, both));
    double[] errors = beside.standardErrors();
    assertEquals(1, beside.columns().length);
    assertEquals(0, errors[0] + errors[1], 0);
    assertEquals(beside.linear().standardErrors()[0], errors[2], 0);
    assertTrue(errors[2] > 0);
    assertArrayEquals(
        new double[] {0.05, 0}, beside.stepped(0).values(STEPS), 0, "what jumps stays");
  }

  /**
   * The way grows in proportion to the factor: one step goes all the way, and as much further as 60
   * degrees of freedom say less of a mean than their weights do.
   */
  @Test
  void aStepGoesWhereAllBlocksFitBest() {
    MotionSteps given = given(1.2, 1.2);
    Slopes slopes = new Slopes(given, fit(given, set(SCALE, 1)));
    assertEquals(1 + 0.2 * STEP, slopes.stepped(0).values()[0], EXACT);
    // Damped as much as there is information, half the way.
    assertEquals(1 + 0.1 * STEP, slopes.stepped(1).values()[0], EXACT);
    // No further than what is allowed.
    MotionSteps faster = given(9, 9);
    assertEquals(5, new Slopes(faster, fit(faster, set(SCALE, 4))).stepped(0).values()[0], 0);
  }

  /** Of five folds the first has the blocks that are faster. */
  @Test
  void aFoldHasNoPartInWhatForetellsIt() {
    MotionSteps given = given(1.202, 1.2);
    Slopes slopes = new Slopes(given, fit(given, set(SCALE, 1.2)));

    assertEquals(1.2, slopes.withoutFold(0).values()[0], EXACT);
    for (int fold = 1; fold < MotionSteps.FOLDS; fold++) {
      double other = slopes.withoutFold(fold).values()[0];
      assertTrue(other > 1.2004 && other < 1.2014, "fold " + fold + ": " + other);
    }
  }

  /** What makes the other blocks no likelier is not taken, however often it is halved. */
  @Test
  void aFoldsStepIsHalvedWhereItGoesTooFar() {
    MotionSteps given = given(1.2, 1.2);
    MotionHypothesis right = set(SCALE, 1.2);
    double[][] off = given.residuals(set(SCALE, 1).chain());
    // Residuals of another set: by them the factor should grow, which makes nothing likelier.
    Slopes slopes = new Slopes(given, new MotionFit(right, off, NOISES, 0));

    assertSame(right, slopes.withoutFold(0));
  }

  @Test
  void slopesOfTheSameResidualsAreTakenOver() {
    MotionSteps given = given(1.2, 1.2);
    MotionFit first = fit(given, set(SCALE, 1));
    Slopes before = new Slopes(given, first);
    MotionHypothesis more = first.hypothesis().with(BIAS, new double[] {0});
    MotionFit same = new MotionFit(more, first.residuals(), NOISES, 0);
    Slopes beside = new Slopes(given, same, Optional.of(before));
    assertEquals(2, beside.raw().length);
    assertSame(before.raw()[0], beside.raw()[0]);

    Slopes other = new Slopes(given, fit(given, more), Optional.of(before));
    assertNotSame(before.raw()[0], other.raw()[0]);
    assertArrayEquals(before.raw()[0][0], other.raw()[0][0], EXACT);
  }

  @Test
  void nearbyMotionChangesAsItDid() {
    MotionSteps given = given(1.2, 1.2);
    Slopes slopes = new Slopes(given, fit(given, set(SCALE, 1)));
    MotionFit next = fit(given, set(SCALE, 1.1));

    assertSame(next, slopes.of(next).fit());
    assertSame(slopes.raw(), slopes.of(next).raw());
    assertSame(next, slopes.anew(next).fit());
    assertNotSame(slopes.raw(), slopes.anew(next).raw());
    assertEquals(1.1 + 0.1 * STEP, slopes.of(next).stepped(0).values()[0], EXACT);
  }
}
