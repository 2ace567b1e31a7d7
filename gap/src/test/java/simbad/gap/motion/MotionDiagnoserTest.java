package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.Command;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.Way;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/** Logs that the model itself makes, with a tracker of one millimetre and a tenth of a degree. */
class MotionDiagnoserTest {
  private static final double SIGMA_M = 0.001;
  private static final double SIGMA_RAD = Math.toRadians(0.1);
  private static final double END_S = 150;

  private static MotionDiagnosis diagnose(MotionChain truth, int seed) {
    return diagnose(truth, seed, 1);
  }

  private static MotionDiagnosis diagnose(MotionChain truth, int seed, double noisier) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Command> commands = new ArrayList<>();
    for (double t = 0; t < END_S; t += 1 + 2 * random.nextDouble()) {
      commands.add(new Command(t, 0.3 * random.nextDouble(), 2 * random.nextDouble() - 1));
    }
    MotionRun blind = new MotionRun("a", commands, List.of());
    Way way = Way.of(blind, truth, 0, END_S);
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i < END_S * 10; i++) {
      Displacement to = way.between(0, i / 10.0);
      track.add(
          new TrackPose(
              i / 10.0,
              to.alongM() + noisier * SIGMA_M * random.nextGaussian(),
              to.acrossM() + noisier * SIGMA_M * random.nextGaussian(),
              Math.IEEEremainder(to.turnRad() + SIGMA_RAD * random.nextGaussian(), 2 * Math.PI)));
    }
    Robot robot = new Robot(false, 0, false, SIGMA_M, SIGMA_RAD, MotionChain.EXACT);
    MotionRun run = new MotionRun("a", commands, track);
    return new MotionDiagnoser(new MotionData("m", robot, List.of(run), List.of())).diagnose();
  }

  private static MotionDiagnosis with(int seed, String form, double... values) {
    MotionChain truth = MotionChain.EXACT.with(MotionForms.find(form).orElseThrow().change(values));
    return diagnose(truth, seed);
  }

  private static void checkNamed(
      MotionDiagnosis diagnosis, String effect, double value, double by) {
    assertEquals(List.of(effect), diagnosis.findings().stream().map(f -> f.effect()).toList());
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict());
    assertEquals(value, diagnosis.findings().get(0).parameters().get(0).value(), by);
    assertTrue(diagnosis.findings().get(0).probability() > 0.95);
    assertTrue(diagnosis.shrink() > 0.3, "shrink " + diagnosis.shrink());
  }

  @Test
  void exactRobot_hasNoGap() {
    assertEquals(Verdict.NONE, diagnose(MotionChain.EXACT, 1).verdict());
  }

  @Test
  void shortTranslations_areSpeedScale() {
    checkNamed(with(2, "speed-scale", 0.93), "speed-scale", 0.93, 0.005);
  }

  @Test
  void bothShort_areOneCause() {
    checkNamed(with(3, "wheel-scale", 0.95), "wheel-scale", 0.95, 0.005);
  }

  @Test
  void lateCommands_areLatency() {
    checkNamed(with(4, "actuation-latency", 0.2), "actuation-latency", 0.2, 0.01);
  }

  @Test
  void gradualSpeeds_areLag() {
    checkNamed(with(5, "actuation-lag: time constants", 0.3, 0.2), "actuation-lag", 0.3, 0.03);
  }

  @Test
  void turningByItself_isBias() {
    checkNamed(with(6, "turn-bias", 0.05), "turn-bias", 0.05, 0.002);
  }

  /** A tracker that scatters by four millimetres where one is believed. */
  @Test
  void noise_isMeasured_withItsInterval() {
    MotionFinding noise = diagnose(MotionChain.EXACT, 7, 4).findings().get(0);

    assertEquals(MotionForms.MOTION_NOISE, noise.effect());
    assertTrue(noise.probability() > 0.99, "sure by " + noise.probability());
    MotionFinding.Parameter sigma = noise.parameters().get(0);
    assertTrue(sigma.ci95().low() < 0.004 && 0.004 < sigma.ci95().high(), sigma.toString());
    assertTrue(sigma.ci95().high() - sigma.ci95().low() < 0.002, sigma.toString());
  }

  /** It turns on and on, and its tracker's heading jumps by whole turns. */
  @Test
  void ratesOfTurning_areThoseOfTheRobot() {
    List<MotionPlace> places = with(8, "turn-bias", 0.05).places();

    for (MotionPlace place : places) {
      if (place.axis().equals("turn_rad_s")) {
        assertTrue(Math.abs(place.low()) < 1.2 && Math.abs(place.high()) < 1.2, place.toString());
      }
    }
    assertTrue(places.stream().anyMatch(place -> place.axis().equals("turn_rad_s")));
  }
}
