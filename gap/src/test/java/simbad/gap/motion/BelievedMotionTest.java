package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.format.MotionData;

/** What a reference takes over from a log, of numbers of nats that are known. */
class BelievedMotionTest {
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final MotionForm LATE = MotionForms.find("actuation-latency").orElseThrow();
  private static final MotionForm GROWING =
      MotionForms.find("speed-scale: growing with the speed").orElseThrow();
  private static final Noise[] NOISES = {
    Noise.believed(0.01), Noise.believed(0.01), Noise.believed(0.01)
  };

  private static MotionRun run(double speed, double seconds) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 5 * seconds; i++) {
      track.add(new TrackPose(i / 5.0, speed * i / 5, 0, 0));
    }
    return new MotionRun("a", List.of(new Command(0, speed, 0)), track);
  }

  private static BelievedMotion believed(double speed, double clumping, FittedMotion... shown) {
    MotionSteps reference = new MotionSteps(List.of(run(speed, 10)));
    return new BelievedMotion(
        MotionForecast.believed(Robot.EXACT_UNICYCLE),
        NOISES,
        List.of(shown),
        Optional.of(new BelievedMotion.Reference(reference, clumping)));
  }

  private static ScoredMotion found(MotionForm form, double... values) {
    MotionSteps log = new MotionSteps(List.of(run(0.1, 4)));
    MotionHypothesis set =
        new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]).with(form, values);
    return ScoredMotion.of(log, new MotionFit(set, log.residuals(set.chain()), NOISES, 0));
  }

  private static boolean isLearnt(double scale, double gain) {
    return believed(0, 1).learning(found(SCALE, scale), form -> gain).isPresent();
  }

  /**
   * A reference that stands says nothing against a scale. Of a hundredth that is practical, 1.03 is
   * 4.5 nats off and 1.05 is 12.5; of a gain of 9 nats the two together lose 1 / (1/a + 1/9).
   */
  @Test
  void whatIsUnusualIsLearntOnlyWhereTheLogSaysLittle() {
    assertTrue(isLearnt(1.03, 1e9));
    assertTrue(isLearnt(0.97, 1e9));
    assertFalse(isLearnt(1.05, 1e9));
    assertFalse(isLearnt(0.95, 1e9));
    // 12.5 and 11.5 lose 5.99, 12.5 and 11.6 lose 6.02.
    assertTrue(isLearnt(1.05, 11.5));
    assertFalse(isLearnt(1.05, 11.6));
    assertTrue(isLearnt(1.05, -3));
  }

  /** Deviations of two values add up by squares: 3 and 2 are 6.5 nats, 3 and 1 are 5. */
  @Test
  void deviationsAddUp() {
    BelievedMotion believed = believed(0, 1);

    assertTrue(believed.learning(found(GROWING, 1.03, 0.05), form -> 1e9).isPresent());
    assertFalse(believed.learning(found(GROWING, 1.03, 0.1), form -> 1e9).isPresent());
    assertTrue(believed.learning(found(GROWING, 1, 0.15), form -> 1e9).isPresent());
  }

  /** A reference whose robot goes as it is told speaks against any scale, the less it is sure. */
  @Test
  void aReferenceSpeaksAgainstWhatItDoesNotShow() {
    ScoredMotion found = found(SCALE, 1.02);
    MotionSteps reference = new MotionSteps(List.of(run(0.5, 10)));
    double[][] without = reference.residuals(MotionChain.EXACT);
    double[][] with = reference.residuals(found.hypothesis().chain());
    double against =
        Whitening.logDensity(reference, NOISES, without)
            - Whitening.logDensity(reference, NOISES, with);
    assertTrue(against > 4, () -> "against " + against);
    // Two hundredths are 2 nats off themselves: 4 are left to the reference.
    double clumping = against / 4;
    assertFalse(believed(0.5, 0.99 * clumping).learning(found, form -> 1e9).isPresent());
    assertTrue(believed(0.5, 1.01 * clumping).learning(found, form -> 1e9).isPresent());
  }

  @Test
  void whatIsLearntStandsBehindWhatWasShown() {
    FittedMotion shown = new FittedMotion(LATE, new double[] {0.1});
    BelievedMotion before = believed(0, 1, shown);
    BelievedMotion learnt = before.learning(found(SCALE, 1.02), form -> 1e9).orElseThrow();

    assertEquals(2, learnt.shown().size());
    assertEquals(LATE, learnt.shown().get(0).form());
    assertEquals(SCALE, learnt.shown().get(1).form());
    assertEquals(0.102, learnt.nominal().chain().speed(0.1, 0), 1e-12);
    assertEquals(before.reference(), learnt.reference());
  }

  @Test
  void withoutAReferenceNothingIsLearnt() {
    BelievedMotion stated =
        new BelievedMotion(
            MotionForecast.believed(Robot.EXACT_UNICYCLE), NOISES, List.of(), Optional.empty());

    assertTrue(stated.learning(found(SCALE, 1.01), form -> 1e9).isEmpty());
  }

  /** Fewer than six blocks of ten seconds cannot be left out in fifths: the file is believed. */
  @Test
  void aShortReferenceIsNone() {
    Robot robot = new Robot(false, 0, false, 0.003, 0.004, MotionChain.EXACT);
    MotionRun run = run(0.1, 50);
    BelievedMotion stated =
        BelievedMotion.of(new MotionData("a", robot, List.of(run), List.of(run)));

    assertTrue(stated.reference().isEmpty());
    assertEquals(List.of(), stated.shown());
    assertEquals(Noise.believed(0.003), stated.noises()[0]);
    assertEquals(Noise.believed(0.003), stated.noises()[1]);
    assertEquals(Noise.believed(0.004), stated.noises()[2]);
  }
}
