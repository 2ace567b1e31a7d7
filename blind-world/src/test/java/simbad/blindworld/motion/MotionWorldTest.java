package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.world.Pose;

/** What a world makes of changes, of its tracker and of runs, with chance and without. */
class MotionWorldTest {

  private static final double NEAR = 1e-9;
  private static final double FREE = Double.POSITIVE_INFINITY;
  private static final MotionWorld.Seeing SHARP = new MotionWorld.Seeing(Robot.Scatter.NONE, 0);

  private static Robot robot(Robot.Beliefs beliefs) {
    return new Robot(0, 0.2, false, beliefs, Robot.Scatter.NONE, false);
  }

  /** Told at once and for the whole run, seen at its ends and its middle. */
  private static Outing.Run run(double v, double w, double forS, double headingRad) {
    Commands commands = new Commands(new double[] {0}, new double[] {v}, new double[] {w});
    return new Outing.Run(
        "r", commands, new double[] {0, forS / 2, forS}, forS, new Pose(0, 0, headingRad));
  }

  private static Track drive(Outing.Run run, MotionChange... changes) {
    MotionWorld world = new MotionWorld(robot(Robot.Beliefs.NONE), SHARP, List.of(changes));
    return world.drive(new Outing(List.of(run)), 1);
  }

  /** One that looks along x has its left up the page, against z. */
  @Test
  void slide_isToTheLeft() {
    MotionChange slides = MotionChange.steps(Stage.WHEEL, step -> step.slideLeft(0.3));
    Track track = drive(run(0.5, 0, 2, 0), slides);
    assertEquals(1, track.xM(0, 2), NEAR);
    assertEquals(-0.6, track.zM(0, 2), NEAR);
    Track up = drive(run(0, 0, 2, Math.PI / 2), slides);
    assertEquals(-0.6, up.xM(0, 2), NEAR);
    assertEquals(0, up.zM(0, 2), NEAR);
  }

  /** Left of a circle is its middle: a slide of s at a turn w is a circle of the radius s / w. */
  @Test
  void slideInATurn_isACircleToo() {
    MotionChange slides = MotionChange.steps(Stage.WHEEL, step -> step.slideLeft(0.3));
    Track track = drive(run(0, 0.5, Math.PI, 0), slides);
    // A quarter: from heading 0 the left goes up the page and then back along x.
    assertEquals(-0.6, track.xM(0, 2), 1e-4);
    assertEquals(-0.6, track.zM(0, 2), 1e-4);
  }

  @Test
  void drift_isOverTheFloorWhateverTheHeading() {
    Track track =
        drive(run(0, 0.7, 2, 1), MotionChange.steps(Stage.WHEEL, step -> step.drift(0.25, -0.5)));
    assertEquals(0.5, track.xM(0, 2), NEAR);
    assertEquals(-1, track.zM(0, 2), NEAR);
    assertEquals(1 + 1.4, track.headingRad(0, 2), NEAR);
  }

  /** Half a turn of half a metre's radius ends a metre beside the begin, at 5 rad/s as well. */
  @Test
  void arc_staysACircleAtAHighTurnRate() {
    double w = 5;
    double forS = 40;
    Track track = drive(run(2.5, w, forS, 0.3));
    double turned = w * forS;
    assertEquals(0.3 + turned, track.headingRad(0, 2), 1e-9);
    assertEquals(0.5 * (Math.sin(0.3 + turned) - Math.sin(0.3)), track.xM(0, 2), 1e-6);
    assertEquals(0.5 * (Math.cos(0.3 + turned) - Math.cos(0.3)), track.zM(0, 2), 1e-6);
  }

  /** What is shown is earlier by the sum of what the changes say; beyond its ends a run stands. */
  @Test
  void frames_showAnEarlierPose() {
    MotionChange ago = MotionChange.acting(Stage.TRACK, random -> ago(0.3));
    MotionChange more = MotionChange.acting(Stage.TRACK, random -> ago(0.25));
    Track track = drive(run(0.5, 0.2, 2, 0), ago, more);
    assertEquals(0.2 * (1 - 0.55), track.headingRad(0, 1), NEAR);
    assertEquals(0, track.headingRad(0, 0), NEAR);
    MotionChange early = MotionChange.acting(Stage.TRACK, random -> ago(-0.7));
    Track later = drive(run(0.5, 0.2, 2, 0), early);
    assertEquals(0.2 * 0.7, later.headingRad(0, 0), NEAR);
    assertEquals(0.4, later.headingRad(0, 2), NEAR);
  }

  private static Acting ago(double s) {
    return new Acting() {
      @Override
      public double agoS(double frameS, double logShare) {
        return s;
      }
    };
  }

  /** 0.2 twice is 0.4 and 0.1 more is 0.5; the other way round it would be 0.6. */
  @Test
  void changes_actInTheOrderOfTheirStages() {
    MotionChange turns = MotionChange.steps(Stage.TURNING, step -> step.addTurn(0.1));
    MotionChange scales = MotionChange.steps(Stage.WHEEL, step -> step.scale(1, 2));
    assertEquals(0.5, drive(run(0, 0.2, 1, 0), turns, scales).headingRad(0, 2), NEAR);
    assertEquals(0.5, drive(run(0, 0.2, 1, 0), scales, turns).headingRad(0, 2), NEAR);
  }

  /** Limits of 0.4 m/s and 0.3 rad/s, either way; a limit of one holds without one of the other. */
  @ParameterizedTest
  @CsvSource({
    "0.4, 0.3, 1, 1, 0.4, 0.3",
    "0.4, 0.3, -1, -1, -0.4, -0.3",
    "0.4, 0.3, 0.2, -0.1, 0.2, -0.1",
    "0.4, Infinity, 1, 1, 0.4, 1",
    "Infinity, 0.3, 1, 1, 1, 0.3",
  })
  void beliefs_limitEachSpeed(
      double mostV, double mostW, double v, double w, double isV, double isW) {
    MotionWorld world = MotionWorld.nominal(robot(new Robot.Beliefs(0, 0, mostV, mostW)));
    Track turning = world.drive(new Outing(List.of(run(v, w, 1, 0))), 1);
    assertEquals(isW, turning.headingRad(0, 2), NEAR);
    Track straight = world.drive(new Outing(List.of(run(v, 0, 1, 0))), 1);
    assertEquals(isV, straight.xM(0, 2), NEAR);
  }

  /** A step of v of a time constant T costs v T; what is believed to be late is late. */
  @Test
  void beliefs_lagBothSpeeds() {
    Robot robot = robot(new Robot.Beliefs(0.5, 0.1, FREE, FREE));
    MotionWorld world = MotionWorld.nominal(robot);
    assertSame(robot, world.robot());
    Track track = world.drive(new Outing(List.of(run(0.5, 0.3, 4, 0))), 1);
    assertEquals(0.3 * (4 - 0.5 - 0.1), track.headingRad(0, 2), 1e-3);
  }

  /** Runs of 1 and 3 s: of the log none, then a quarter lies before them. */
  @Test
  void logShare_goesOnOverTheRuns() {
    List<Double> begun = new ArrayList<>();
    List<Double> seen = new ArrayList<>();
    MotionChange looks =
        MotionChange.acting(
            Stage.TRACK,
            random ->
                new Acting() {
                  private boolean first;

                  @Override
                  public void beginRun() {
                    first = true;
                  }

                  @Override
                  public void move(Step step) {
                    if (first) {
                      begun.add(step.logShare());
                      begun.add(step.timeS());
                      begun.add(step.logS());
                    }
                    first = false;
                  }

                  @Override
                  public double agoS(double frameS, double logShare) {
                    seen.add(logShare);
                    return 0;
                  }
                });
    MotionWorld world = new MotionWorld(robot(Robot.Beliefs.NONE), SHARP, List.of(looks));
    Outing.Run late =
        new Outing.Run(
            "s",
            new Commands(new double[] {2}, new double[] {1}, new double[1]),
            new double[] {3.5, 5},
            5,
            new Pose(7, 8, 0));
    Track track = world.drive(new Outing(List.of(run(1, 0, 1, 0), late)), 1);
    assertEquals(List.of(0.0, 0.0, 4.0, 0.25, 2.0, 4.0), begun);
    assertEquals(List.of(0.0, 0.125, 0.25, 0.625, 1.0), seen);
    assertEquals(7 + 1.5, track.xM(1, 0), NEAR);
    assertEquals(8, track.zM(1, 1), NEAR);
  }

  /** The first step has had none before it: a robot begins at rest. */
  @Test
  void lastSpeeds_areThoseAfterAllChanges() {
    List<Double> last = new ArrayList<>();
    MotionChange looks =
        MotionChange.steps(
            Stage.WHEEL,
            step -> {
              last.add(step.lastV());
              step.scale(2, 1);
            });
    Outing.Run run = run(1, 0, 0.04, 0);
    new MotionWorld(robot(Robot.Beliefs.NONE), SHARP, List.of(looks))
        .drive(new Outing(List.of(run, run)), 1);
    assertEquals(List.of(0.0, 2.0, 0.0, 2.0), last);
  }

  private static double[] scatter(Robot.Scatter scatter, double tails, int column) {
    double[] frames = IntStream.range(0, 4000).mapToDouble(i -> i / 100.0).toArray();
    Commands none = new Commands(new double[0], new double[0], new double[0]);
    Outing.Run run = new Outing.Run("r", none, frames, 40, new Pose(0, 0, 0));
    MotionWorld world =
        new MotionWorld(
            robot(Robot.Beliefs.NONE), new MotionWorld.Seeing(scatter, tails), List.of());
    Track track = world.drive(new Outing(List.of(run)), 5);
    return IntStream.range(0, frames.length)
        .mapToDouble(
            i -> column == 0 ? track.xM(0, i) : column == 1 ? track.zM(0, i) : turn(track, i))
        .toArray();
  }

  private static double turn(Track track, int frame) {
    return track.headingRad(0, frame);
  }

  private static double deviation(double[] values) {
    return Math.sqrt(Arrays.stream(values).map(x -> x * x).average().orElseThrow());
  }

  /**
   * Of 4000 frames a standard deviation is known to 1.1 per cent; with tails of a half the mean
   * square is (1 + 9) / 2 of it, and its error three times as much.
   */
  @Test
  void tracker_scattersAsItIsSaid() {
    Robot.Scatter both = new Robot.Scatter(0.01, 0.002);
    for (int column = 0; column < 3; column++) {
      double sigma = column < 2 ? 0.01 : 0.002;
      assertEquals(sigma, deviation(scatter(both, 0, column)), 0.05 * sigma);
      assertEquals(3 * sigma, deviation(scatter(both, 1, column)), 0.15 * sigma);
      double mixed = sigma * Math.sqrt(5);
      assertEquals(mixed, deviation(scatter(both, 0.5, column)), 0.1 * mixed);
    }
    assertEquals(0, deviation(scatter(new Robot.Scatter(0.01, 0), 0, 2)));
    assertEquals(0, deviation(scatter(new Robot.Scatter(0, 0.1), 0, 1)));
  }

  /** A tail takes the whole frame: where x is far out, z is so more often than elsewhere. */
  @Test
  void tail_isOfTheWholeFrame() {
    double[] x = scatter(new Robot.Scatter(1, 0), 0.1, 0);
    double[] z = scatter(new Robot.Scatter(1, 0), 0.1, 1);
    double[] beside =
        IntStream.range(0, x.length)
            .filter(i -> Math.abs(x[i]) > 4)
            .mapToDouble(i -> z[i])
            .toArray();
    assertEquals(3, deviation(beside), 0.8, beside.length + " frames");
    assertNotEquals(x[0], z[0]);
  }
}
