package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/** A drive straight on at 10 cm/s that is seen every tenth of a second, cut into steps. */
class MotionStepsTest {
  private static final double EXACT = 1e-9;
  private static final List<Command> COMMANDS =
      List.of(new Command(0, 0.1, 0), new Command(1, 0.3, 0), new Command(2, 0.1, 0.5));

  private static TrackPose straight(double timeS) {
    return new TrackPose(timeS, 0.1 * timeS, 0, 0);
  }

  /** Poses from one time to another, so many in ten seconds. */
  private static MotionRun run(String name, double fromS, double toS) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= Math.round((toS - fromS) * 10); i++) {
      track.add(straight(fromS + i / 10.0));
    }
    return new MotionRun(name, List.of(new Command(0, 0.1, 0)), track);
  }

  private static MotionSteps steps(double fromS, double toS) {
    return new MotionSteps(List.of(run("a", fromS, toS)));
  }

  private static MotionSteps seenAt(double... timesS) {
    return new MotionSteps(
        List.of(
            new MotionRun(
                "a",
                List.of(new Command(0, 0.1, 0)),
                Arrays.stream(timesS).mapToObj(MotionStepsTest::straight).toList())));
  }

  /** A fifth of a second each: two poses on. */
  @Test
  void stepsFollowOneAnother() {
    MotionSteps given = steps(0, 2);

    assertEquals(10, given.size());
    assertFalse(given.isChained(0));
    assertTrue(given.isChained(1) && given.isChained(9));
    assertEquals(0.2, given.durationS(3), EXACT);
    assertEquals(0.2, given.step(3).durationS(), EXACT);
    assertEquals(0.6, given.step(3).from().timeS(), EXACT);
    assertEquals(given.step(4).from(), given.step(3).to());
  }

  /** Over more than three seconds nothing hangs together. */
  @Test
  void aHoleIsNoStep() {
    MotionSteps held = seenAt(0, 0.2, 3.2, 3.4);
    assertEquals(3, held.size());
    assertTrue(held.isChained(2));
    MotionSteps hole = seenAt(0, 0.2, 3.3, 3.5);
    assertEquals(2, hole.size());
    assertFalse(hole.isChained(1));
    assertEquals(3.3, hole.step(1).from().timeS(), EXACT);
  }

  @Test
  void beforeItsFirstCommandARobotIsNotKnown() {
    MotionSteps given = steps(-1, 1);

    assertEquals(5, given.size());
    assertEquals(0, given.step(0).from().timeS(), EXACT);
    assertFalse(given.isChained(0));
  }

  @Test
  void whatIsLeftOutTearsTheChain() {
    MotionSteps given = steps(0, 2);
    MotionSteps less = given.without(List.of(new MotionSteps.Stretch(0, 0.5, 0.9)));
    assertEquals(7, less.size());
    assertEquals(1, less.step(2).from().timeS(), EXACT);
    assertFalse(less.isChained(2));
    assertTrue(less.isChained(1) && less.isChained(3));
    assertEquals(10, given.without(List.of(new MotionSteps.Stretch(1, 0.5, 0.9))).size());
    // Told something else, the same steps are left.
    MotionSteps told = less.told(List.of(run("b", 0, 2)));
    assertEquals(7, told.size());
    assertEquals("b", told.runs().get(0).name());
  }

  @Test
  void aStretchMeetsWhatOverlapsIt() {
    MotionSteps.Stretch stretch = new MotionSteps.Stretch(2, 1, 3);

    assertTrue(stretch.meets(2, 0, 1.1) && stretch.meets(2, 2.9, 9) && stretch.meets(2, 1.5, 2));
    assertFalse(stretch.meets(2, 0, 1));
    assertFalse(stretch.meets(2, 3, 4));
    assertFalse(stretch.meets(1, 1.5, 2));
  }

  /** Told to go 2 cm in a step, seen to go 3 and to turn from just under half a turn on. */
  @Test
  void residualsAreWhatWasSeenLessWhatIsExpected() {
    double heading = 3.1;
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      double way = 0.03 * i;
      double seen = Math.IEEEremainder(heading + 0.1 * i, 2 * Math.PI);
      track.add(new TrackPose(0.2 * i, way * Math.cos(heading), way * Math.sin(heading), seen));
    }
    MotionSteps given =
        new MotionSteps(List.of(new MotionRun("a", List.of(new Command(0, 0.1, 0)), track)));
    double[][] residuals = given.residuals(MotionChain.EXACT);
    double[][] expected = given.expected(MotionChain.EXACT);

    assertEquals(0.01, residuals[0][0], EXACT);
    assertEquals(0, residuals[1][0], EXACT);
    assertArrayEquals(new double[] {0.1, 0.1, 0.1}, residuals[2], EXACT);
    assertArrayEquals(new double[] {0.02, 0.02, 0.02}, expected[0], EXACT);
    assertArrayEquals(new double[3], expected[2], EXACT);
    // A step later it has turned by a tenth and goes on as before: seen from itself to the right.
    assertEquals(-0.03 * Math.sin(0.1), residuals[1][1], EXACT);
  }

  @Test
  void eachRunHasItsResiduals() {
    MotionRun fast = new MotionRun("b", List.of(new Command(0, 0.15, 0)), run("b", 0, 2).track());
    MotionSteps given = new MotionSteps(List.of(run("a", 0, 2), fast));
    double[][] residuals = given.residuals(MotionChain.EXACT);

    assertEquals(20, given.size());
    assertEquals(0, residuals[0][9], EXACT);
    assertEquals(-0.01, residuals[0][10], EXACT);
    assertEquals(1, given.step(10).run());
    assertFalse(given.isChained(10));
  }

  /** Blocks of ten seconds, left out in turns of five; the next run begins one later. */
  @Test
  void blocksAreTensOfSeconds() {
    MotionSteps given = new MotionSteps(List.of(run("a", 0, 25), run("b", 0, 12)));

    assertEquals(5, given.blockCount());
    assertEquals(0, given.block(49));
    assertEquals(1, given.block(50));
    assertEquals(3, given.block(125));
    assertEquals(2, given.foldOf(2));
    assertEquals(1, given.foldOf(3));
    assertEquals(2, given.foldOf(4));
    assertEquals(0, MotionSteps.fold(1, 45));
    assertEquals(4, MotionSteps.fold(0, 49.9));
    assertEquals(4, MotionSteps.fold(0, -5));
  }

  /** In units of the mean, and a twentieth for a robot that stands. */
  @Test
  void whatIsAskedIsInUnitsOfTheMean() {
    double[] loads = steps(0, 4).loads();
    assertEquals(1.05, Arrays.stream(loads).average().orElseThrow(), EXACT);
    // Later on only the way counts, at first the change from rest too.
    assertEquals(loads[10], loads[19], EXACT);
    assertTrue(loads[0] > loads[10] && loads[10] > 0.05);

    MotionRun stands = new MotionRun("a", List.of(Command.STAND), run("a", 0, 1).track());
    assertArrayEquals(
        new double[] {1, 1, 1, 1, 1}, new MotionSteps(List.of(stands)).loads(), EXACT);
  }

  /** At 1 s by 0.2 m/s, at 2 s by as much back: each in two steps, 0.15 s to either side. */
  @Test
  void changesBelongToTheStepsTheyFallInto() {
    MotionRun run = new MotionRun("a", COMMANDS, run("a", 0, 4).track());
    MotionSteps given = new MotionSteps(List.of(run));
    double[] expected = new double[20];
    // Four of twenty steps see a change: five times the mean.
    for (int step : new int[] {4, 5, 9, 10}) {
      expected[step] = 5;
    }
    assertArrayEquals(expected, given.changes(0, 0), EXACT);
    double[] later = new double[20];
    System.arraycopy(expected, 0, later, 2, 18);
    assertArrayEquals(later, given.changes(0, 0.4), EXACT);
    double[] turns = new double[20];
    turns[9] = 10;
    turns[10] = 10;
    assertArrayEquals(turns, given.changes(2, 0), EXACT);
    assertArrayEquals(new double[5], steps(0, 1).changes(2, 0), 0);
  }

  /** 41 blocks: every second one, each with fifty steps but the last. */
  @Test
  void aLongLogIsSampled() {
    MotionSteps given = steps(0, 401);
    MotionSteps sample = given.sample();

    assertEquals(2005, given.size());
    assertEquals(20 * 50 + 5, sample.size());
    assertEquals(20, sample.step(50).from().timeS(), EXACT);
    assertEquals(0, Arrays.stream(sample.residuals(MotionChain.EXACT)[0]).sum(), 1e-6);
    MotionSteps shorter = steps(0, 395);
    assertEquals(40, shorter.blockCount());
    assertTrue(shorter.sample().size() < shorter.size());
    MotionSteps shortOne = steps(0, 389.5);
    assertSame(shortOne, shortOne.sample());
  }

  @Test
  void anAngleIsNeverMoreThanHalfATurn() {
    assertEquals(1.5, MotionSteps.wrapped(1.5), 0);
    assertEquals(0.5 - Math.PI, MotionSteps.wrapped(Math.PI + 0.5), EXACT);
    assertEquals(Math.PI - 0.5, MotionSteps.wrapped(-Math.PI - 0.5), EXACT);
  }

  @Test
  void aCommandIsHeldTillTheNext() {
    assertSame(COMMANDS.get(0), CommandTrail.held(COMMANDS, -1));
    assertSame(COMMANDS.get(0), CommandTrail.held(COMMANDS, 0.99));
    assertSame(COMMANDS.get(1), CommandTrail.held(COMMANDS, 1));
    assertSame(COMMANDS.get(1), CommandTrail.held(COMMANDS, 1.5));
    assertSame(COMMANDS.get(2), CommandTrail.held(COMMANDS, 7));
  }

  @Test
  void betweenTwoTimesActsWhatWasHeldAndWhatComes() {
    assertEquals(
        List.of(new Command(0.5, 0.1, 0), COMMANDS.get(1), COMMANDS.get(2)),
        CommandTrail.between(COMMANDS, 0.5, 2));
    assertEquals(
        List.of(COMMANDS.get(0), COMMANDS.get(1)), CommandTrail.between(COMMANDS, -1, 1.9));
    assertEquals(List.of(new Command(2.5, 0.1, 0.5)), CommandTrail.between(COMMANDS, 2.5, 3));
    assertEquals(List.of(COMMANDS.get(1)), CommandTrail.between(COMMANDS, 1, 1.5));
  }

  /** 0.2 m/s up at 1 s and down at 2 s, where it turns by 0.5 rad/s. */
  @Test
  void changesAddUpBySquares() {
    assertEquals(0.08, CommandTrail.changed(COMMANDS, false, 0, 2), EXACT);
    assertEquals(0.04, CommandTrail.changed(COMMANDS, false, 1, 1.9), EXACT);
    assertEquals(0.04, CommandTrail.changed(COMMANDS, false, 1.1, 5), EXACT);
    assertEquals(0.25, CommandTrail.changed(COMMANDS, true, -3, 5), EXACT);
    assertEquals(0, CommandTrail.changed(COMMANDS, true, 2.1, 5), 0);
    assertEquals(0, CommandTrail.changed(COMMANDS, true, 0, 1.5), 0);
  }
}
