package simbad.blindworld.motiondrive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Track;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;

/** Robots, logs and set-ups over many draws. */
class MotionDesignTest {

  private static final double FREE = Double.POSITIVE_INFINITY;

  private static void assertWithin(double least, double most, double value) {
    assertTrue(value >= least && value <= most, least + " " + value + " " + most);
  }

  private static MotionDesign design(long seed) {
    return MotionDesign.draw(new Chance(seed));
  }

  @Test
  void rounding_isToDecimals() {
    assertEquals(1.235, MotionDesign.rounded(1.23456, 3), 1e-12);
    assertEquals(-12, MotionDesign.rounded(-12.4, 0), 1e-12);
  }

  @Test
  void robot_isDrawnInItsRanges() {
    Set<String> kinds = new HashSet<>();
    int differential = 0;
    int separate = 0;
    int limited = 0;
    int late = 0;
    for (int seed = 0; seed < 400; seed++) {
      MotionDesign design = design(seed);
      Robot robot = design.robot();
      kinds.add(design.kind());
      assertWithin(0.05, 0.5, robot.wheelBaseM());
      assertWithin(
          0.15 * robot.wheelBaseM() - 1e-4, 0.4 * robot.wheelBaseM() + 1e-4, robot.wheelRadiusM());
      double base = robot.wheelBaseM();
      assertWithin(base + 0.0495, 3 * base + 0.0505, design.mostMPerS());
      assertWithin(0.7, 1.8, design.mostRadPerS());
      assertWithin(2, 67, design.commandsPerS());
      assertWithin(0.0003, 0.005, robot.tracker().positionM());
      assertWithin(0.05, 1, Math.toDegrees(robot.tracker().headingRad()));
      differential += robot.differential() ? 1 : 0;
      separate += robot.separateClocks() ? 1 : 0;
      Robot.Beliefs beliefs = robot.beliefs();
      limited += beliefs.maxSpeedMPerS() < FREE ? 1 : 0;
      assertEquals(beliefs.maxSpeedMPerS() < FREE, beliefs.maxTurnRadPerS() < FREE);
      if (beliefs.maxSpeedMPerS() < FREE) {
        // Limits are above all that is asked for.
        assertEquals(1.2 * design.mostMPerS() + 0.01, beliefs.maxSpeedMPerS(), 0.0051);
        assertEquals(1.2 * design.mostRadPerS() + 0.1, beliefs.maxTurnRadPerS(), 0.051);
      }
      late += beliefs.latencyS() > 0 ? 1 : 0;
      assertTrue(beliefs.latencyS() == 0 || beliefs.latencyS() >= 0.03);
      assertWithin(0, 0.25, beliefs.latencyS());
      assertTrue(beliefs.timeConstantS() == 0 || beliefs.timeConstantS() >= 0.05);
      assertWithin(0, 0.3, beliefs.timeConstantS());
    }
    assertEquals(9, kinds.size());
    // Five standard errors of 400 draws.
    assertEquals(0.5, differential / 400.0, 0.125);
    assertEquals(0.25, separate / 400.0, 0.11);
    assertEquals(1 / 3.0, limited / 400.0, 0.12);
    assertEquals(0.3, late / 400.0, 0.115);
  }

  /** Commands begin within a second of the camera and end with a stop 0.4 s before its end. */
  @Test
  void outing_isMadeOfWholeRuns() {
    for (int seed = 0; seed < 60; seed++) {
      MotionDesign design = design(seed);
      Outing outing = design.outing(120, new Chance(seed));
      assertWithin(1, 3, outing.runs().size());
      assertWithin(0.8 * 120, 1.2 * 120, outing.durationS());
      for (int r = 0; r < outing.runs().size(); r++) {
        Outing.Run run = outing.runs().get(r);
        assertEquals("run-" + (r + 1), run.name());
        assertWithin(-1, 1, run.start().xM());
        assertWithin(-1, 1, run.start().zM());
        double begin = run.frameS(0);
        assertEquals(Math.rint(begin), begin, 1e-9);
        assertWithin(0, 200, begin);
        assertEquals(Math.rint(2 * run.endS()), 2 * run.endS(), 1e-9);
        Commands told = run.commands();
        assertWithin(begin + 0.1, begin + 0.9, told.timeS(0));
        int last = told.size() - 1;
        assertEquals(Commands.Speeds.ZERO, told.at(last));
        assertWithin(run.endS() - 0.4005, run.endS() + 0.9, told.timeS(last));
        for (int i = 1; i < last; i++) {
          assertTrue(told.timeS(i) > told.timeS(i - 1));
          assertWithin(-1.02 * design.mostMPerS(), 1.02 * design.mostMPerS(), told.at(i).vMPerS());
        }
        double rate = (last - 1) / (told.timeS(last - 1) - told.timeS(0));
        assertWithin(0.7 * design.commandsPerS(), 1.15 * design.commandsPerS(), rate);
        assertWithin(begin, run.endS() + 1e-9, run.frameS(run.frames() - 1));
      }
    }
  }

  /** As far as commands tell, a robot comes back when it is more than 8 s of its speed away. */
  @Test
  void robot_staysInItsRoom() {
    double most = 0;
    for (int seed = 0; seed < 60; seed++) {
      MotionDesign design = design(seed);
      Outing outing = design.outing(300, new Chance(seed));
      double reach = 8 * design.mostMPerS();
      for (Outing.Run run : outing.runs()) {
        double x = run.start().xM();
        double z = run.start().zM();
        double heading = run.start().headingRad();
        Commands told = run.commands();
        for (int i = 0; i + 1 < told.size(); i++) {
          double dt = told.timeS(i + 1) - told.timeS(i);
          double middle = heading + told.at(i).wRadPerS() * dt / 2;
          x += told.at(i).vMPerS() * dt * Math.cos(middle);
          z -= told.at(i).vMPerS() * dt * Math.sin(middle);
          heading += told.at(i).wRadPerS() * dt;
          double share = Math.hypot(x, z) / reach;
          most = Math.max(most, share);
          assertTrue(Math.hypot(x, z) < 1.8 * reach + 1.5, design.kind() + " " + share);
        }
      }
    }
    assertTrue(most > 0.9, "some come to the fence: " + most);
  }

  /** A fast camera films for a shorter while: 24,000 frames at most, give or take a seventh. */
  @Test
  void log_hasNoEndOfFrames() {
    for (int seed = 0; seed < 30; seed++) {
      Outing outing = design(seed).outing(3000, new Chance(seed));
      int frames = outing.runs().stream().mapToInt(Outing.Run::frames).sum();
      assertWithin(5000, 24_000 * 1.16, frames);
      assertWithin(1, 4, outing.runs().size());
    }
  }

  private static double[] deviations(MotionDesign design, MotionSetup setup, double v, double w) {
    Robot still = design.robot().withTracker(Robot.Scatter.NONE);
    Robot plain =
        new Robot(
            still.wheelRadiusM(),
            still.wheelBaseM(),
            false,
            Robot.Beliefs.NONE,
            Robot.Scatter.NONE,
            false);
    MotionWorld world =
        new MotionWorld(plain, new MotionWorld.Seeing(Robot.Scatter.NONE, 0), setup.own());
    Commands told = new Commands(new double[1], new double[] {v}, new double[] {w});
    Outing outing =
        new Outing(List.of(new Outing.Run("r", told, new double[] {0, 5}, 5, new Pose(0, 0, 0))));
    int repeats = 600;
    double way = 0;
    double turn = 0;
    for (int i = 0; i < repeats; i++) {
      Track track = world.drive(outing, i);
      double along = track.xM(0, 1) - 5 * v;
      double turned = track.headingRad(0, 1) - 5 * w;
      way += along * along;
      turn += turned * turned;
    }
    return new double[] {Math.sqrt(way / repeats), Math.sqrt(turn / repeats)};
  }

  /**
   * After 5 s at half of the greatest speed, or at a third of the greatest turn rate, a robot is
   * off by 0.175 of what its tracker is. What hangs together over 0.425 s is a few per cent less.
   */
  @Test
  void ownScatter_isAShareOfTheTrackers() {
    MotionDesign design = design(4);
    MotionSetup setup = MotionSetup.asBelieved(design, new FixedChance(0.5));
    Robot.Scatter tracker = design.robot().tracker();
    assertEquals(design.robot(), setup.robot());
    assertEquals(new MotionWorld.Seeing(tracker, 0), setup.seeing());
    assertEquals(1, setup.own().size());
    assertTrue(setup.words().contains("constantS=0.425"), setup.words());
    double[] driven = deviations(design, setup, design.mostMPerS() / 2, 0);
    assertEquals(0.96 * 0.175 * tracker.positionM(), driven[0], 0.12 * 0.175 * tracker.positionM());
    assertEquals(
        0.96 * 0.175 * tracker.headingRad(), driven[1], 0.12 * 0.175 * tracker.headingRad());
    double[] turned = deviations(design, setup, 0, design.mostRadPerS() / 3);
    assertEquals(0, turned[0], 1e-12);
    assertEquals(
        0.96 * 0.175 * tracker.headingRad(), turned[1], 0.12 * 0.175 * tracker.headingRad());
  }

  /** By chance of 0.75: a lag of 22.5 ms, a factor of 1.005, 0.005 rad/m and tails of 0.04. */
  @Test
  void setUp_isALittleOff() {
    MotionDesign design = design(4);
    MotionSetup setup = MotionSetup.off(design, new FixedChance(0.75));
    assertEquals(design.robot(), setup.robot(), "the tracker is stated in two of three");
    assertEquals(
        new MotionWorld.Seeing(design.robot().tracker(), 0.04).tails(),
        setup.seeing().tails(),
        1e-12);
    assertTrue(
        setup.words().endsWith("lag 0.023 s, factor 1.0050, curve 0.0050 rad/m, tails 0.040")
            || setup
                .words()
                .endsWith("lag 0.022 s, factor 1.0050, curve 0.0050 rad/m, tails 0.040"),
        setup.words());
    assertEquals(3, setup.own().size());
    MotionChange scale = setup.own().get(1);
    Robot plain = new Robot(0, 1, false, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
    MotionWorld world =
        new MotionWorld(plain, new MotionWorld.Seeing(Robot.Scatter.NONE, 0), List.of(scale));
    Commands told = new Commands(new double[1], new double[] {0.4}, new double[] {0.5});
    Track track =
        world.drive(
            new Outing(
                List.of(new Outing.Run("r", told, new double[] {0, 2}, 2, new Pose(0, 0, 0)))),
            1);
    double v = 0.4 * 1.005;
    assertEquals(2 * (0.5 * 1.005 + 0.005 * v), track.headingRad(0, 1), 1e-9);
    MotionSetup silent = MotionSetup.off(design, new FixedChance(0.1).coins(false));
    assertEquals(Robot.Scatter.NONE, silent.robot().tracker());
    assertEquals(0, silent.seeing().tails());
    assertEquals(design.robot().tracker(), silent.seeing().scatter());
  }
}
