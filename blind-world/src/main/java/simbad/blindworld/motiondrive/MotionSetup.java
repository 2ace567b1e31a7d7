package simbad.blindworld.motiondrive;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Lag;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Wandering;

/**
 * What there is before any effect: the robot's own scatter, and where a reference tells of it a
 * little more that a simulator does not know.
 *
 * @param robot what the simulator believes
 * @param seeing how the tracker really scatters
 * @param own what is at work always
 * @param words that say so
 */
public record MotionSetup(
    Robot robot, MotionWorld.Seeing seeing, List<MotionChange> own, String words) {

  /** Windows last up to this long: over it the scatter of a robot is compared with a tracker's. */
  private static final double LONG_S = 5;

  /** Copies the list. */
  public MotionSetup {
    own = List.copyOf(own);
  }

  /**
   * How much a robot scatters by itself.
   *
   * @param alongPerRootM standard deviation of the way after a metre
   * @param turnPerRootM of the heading after a metre, in radians
   * @param turnPerRootRad of the heading after a turn of a radian
   * @param constantS for how long it hangs together
   */
  private record OwnScatter(
      double alongPerRootM, double turnPerRootM, double turnPerRootRad, double constantS) {

    /** Noise of correlation time c and deviation s walks by s sqrt(2 c t) in a long time t. */
    MotionChange change() {
      double per = 1 / Math.sqrt(2 * constantS);
      return MotionChange.acting(
          Stage.CHANCE,
          random -> {
            Wandering along = new Wandering(constantS, random);
            Wandering turn = new Wandering(constantS, random);
            return MotionChange.moving(
                step -> {
                  double rootV = Math.sqrt(Math.abs(step.v()));
                  double rootW = Math.sqrt(Math.abs(step.w()));
                  double more = per * alongPerRootM * rootV * along.next();
                  double turned = per * (turnPerRootM * rootV + turnPerRootRad * rootW);
                  step.set(step.v() + more, step.w() + turned * turn.next());
                });
          });
    }
  }

  /**
   * A set-up as it is believed, but for a scatter that the tracker's hides.
   *
   * @param design whose robot it is
   */
  public static MotionSetup asBelieved(MotionDesign design, RandomGenerator random) {
    OwnScatter scatter = scatter(design, random.nextDouble(0.05, 0.3), random);
    Robot robot = design.robot();
    return new MotionSetup(
        robot,
        new MotionWorld.Seeing(robot.tracker(), 0),
        List.of(scatter.change()),
        scatter.toString());
  }

  /** Scatter as large as so many times the tracker's after a long window. */
  private static OwnScatter scatter(MotionDesign design, double times, RandomGenerator random) {
    Robot.Scatter tracker = design.robot().tracker();
    double wayM = LONG_S * design.mostMPerS() / 2;
    double turnRad = LONG_S * design.mostRadPerS() / 3;
    return new OwnScatter(
        times * tracker.positionM() / Math.sqrt(wayM),
        times * tracker.headingRad() / Math.sqrt(wayM),
        times * tracker.headingRad() / Math.sqrt(turnRad),
        random.nextDouble(0.05, 0.8));
  }

  /**
   * A set-up that is a little off: more scatter than the tracker's, some of it heavy-tailed; and a
   * lag, a scale and a curve that are too small to be practical. A reference tells of it.
   */
  public static MotionSetup off(MotionDesign design, RandomGenerator random) {
    OwnScatter scatter = scatter(design, random.nextDouble(0.5, 3), random);
    double lagS = random.nextDouble(0, 0.03);
    double factor = 1 + random.nextDouble(-0.01, 0.01);
    double perM = random.nextDouble(-0.01, 0.01);
    double tails = random.nextBoolean() ? random.nextDouble(0.01, 0.05) : 0;
    List<MotionChange> own = new ArrayList<>();
    own.add(Lag.firstOrder(lagS, lagS));
    own.add(
        MotionChange.steps(
            Stage.WHEEL,
            step -> {
              step.scale(factor, factor);
              step.addTurn(perM * step.v());
            }));
    own.add(scatter.change());
    Robot.Scatter tracker = design.robot().tracker();
    boolean said = random.nextInt(3) > 0;
    return new MotionSetup(
        design.robot().withTracker(said ? tracker : Robot.Scatter.NONE),
        new MotionWorld.Seeing(tracker, tails),
        own,
        String.format(
            Locale.ROOT,
            "%s, lag %.3f s, factor %.4f, curve %.4f rad/m, tails %.3f",
            scatter,
            lagS,
            factor,
            perM,
            tails));
  }
}
