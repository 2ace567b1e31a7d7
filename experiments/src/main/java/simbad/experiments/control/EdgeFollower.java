package simbad.experiments.control;

import simbad.sonar.frame.Angles;
import simbad.sonar.sensing.Readings;

/**
 * Follows the line at which the belt just loses what it hears, keeping it on the left.
 *
 * <p>Nothing heard since the start: drive ahead. Something heard: drive away from what is heard
 * until it is lost; there is the edge. From then on only whether anything is heard matters, so that
 * the same controller serves every sensor model: smooth steering along the edge, and a march on a
 * lattice where the smooth steering goes round on one spot, or where one place says now this, now
 * that.
 */
public final class EdgeFollower implements Controller {
  private enum Stage {
    SEARCH,
    LEAVE,
    FOLLOW
  }

  /** Steps without an echo until it counts as lost: noise alone misses one now and then. */
  private static final int LOST_AFTER = 3;

  /** A sum of directions that is shorter has none of its own. */
  private static final double NO_DIRECTION = 1e-6;

  private static final int WATCH_STEPS = 400;

  /** A robot that stays in a square of so many steps for a whole watch goes round on one spot. */
  private static final double CAUGHT_STEPS = 30;

  private final Tuning tuning;
  private final Odometry odometry;
  private final Whereabouts whereabouts = new Whereabouts();
  private final Flicker flicker = new Flicker();
  private Stage stage = Stage.SEARCH;
  private Steering steering;
  private int silent;
  private double awayRad;
  private double heardXM;
  private double heardZM;
  private double nearestM;
  private boolean marches;

  /**
   * Creates a controller at rest that has heard nothing.
   *
   * @param tuning its parameters
   */
  public EdgeFollower(Tuning tuning) {
    this.tuning = tuning;
    odometry = new Odometry(tuning.stepS());
    steering = new SmoothSteering(tuning, 0, 0, 0);
  }

  @Override
  public void decide(Readings readings, Command command) {
    boolean heard = isAnyEcho(readings);
    silent = heard ? 0 : silent + 1;
    switch (stage(heard)) {
      case SEARCH -> command.set(tuning.speedMPerS(), 0);
      case LEAVE -> leave(readings, command);
      case FOLLOW -> follow(heard, command);
    }
    odometry.advance(command);
  }

  private Stage stage(boolean heard) {
    if (heard) {
      heardXM = odometry.xM();
      heardZM = odometry.zM();
    }
    if (stage == Stage.SEARCH && heard) {
      stage = Stage.LEAVE;
    } else if (stage == Stage.LEAVE && silent >= LOST_AFTER) {
      // The robot came straight from the obstacle: the edge lies across its way.
      stage = Stage.FOLLOW;
      steering = new SmoothSteering(tuning, odometry.headingRad() + Math.PI / 2, heardXM, heardZM);
    }
    return stage;
  }

  private void leave(Readings readings, Command command) {
    aimAway(readings);
    double turnRad = Angles.signed(awayRad - odometry.headingRad());
    double most = tuning.mostRadPerStep();
    // What takes more than one step is turned on the spot: ahead lies the obstacle.
    boolean onTheSpot = Math.abs(turnRad) > most;
    double turnNowRad = Math.max(-most, Math.min(most, turnRad));
    command.set(onTheSpot ? 0 : tuning.speedMPerS(), turnNowRad / tuning.stepS());
  }

  private void follow(boolean heard, Command command) {
    if (!marches && flicker.asks(heard)) {
      command.set(0, 0);
      return;
    }
    if (steering.isOver()) {
      steering = new SmoothSteering(tuning, odometry.headingRad(), odometry.xM(), odometry.zM());
      marches = false;
      whereabouts.restart();
    } else if (!marches && flicker.isProven()) {
      steering = TriangleMarch.patient(tuning, heard);
      marches = true;
    } else if (!marches && whereabouts.isCaught(odometry)) {
      steering = TriangleMarch.fine(tuning.inBends(), heard);
      marches = true;
    }
    steering.steer(heard, odometry, command);
  }

  /**
   * Aims away from the mean direction of the transducers that hear. Where all of them do there is
   * no such direction, but ranges tell: a robot that comes nearer turns back.
   */
  private void aimAway(Readings readings) {
    double ahead = 0;
    double left = 0;
    double nowNearestM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < readings.size(); i++) {
      if (readings.isEcho(i)) {
        double directionRad = 2 * Math.PI * i / readings.size();
        ahead += Math.cos(directionRad);
        left += Math.sin(directionRad);
        nowNearestM = Math.min(nowNearestM, readings.rangeM(i));
      }
    }
    if (Math.hypot(ahead, left) > NO_DIRECTION) {
      awayRad = odometry.headingRad() + Math.atan2(-left, -ahead);
    } else if (nowNearestM < nearestM) {
      awayRad = odometry.headingRad() + Math.PI;
    }
    nearestM = nowNearestM;
  }

  private static boolean isAnyEcho(Readings readings) {
    for (int i = 0; i < readings.size(); i++) {
      if (readings.isEcho(i)) {
        return true;
      }
    }
    return false;
  }

  /** How far the robot got about during the current watch. */
  private final class Whereabouts {
    private int steps;
    private double leastXM;
    private double mostXM;
    private double leastZM;
    private double mostZM;

    void restart() {
      steps = 0;
    }

    boolean isCaught(Odometry at) {
      if (steps++ == 0) {
        leastXM = mostXM = at.xM();
        leastZM = mostZM = at.zM();
      }
      leastXM = Math.min(leastXM, at.xM());
      mostXM = Math.max(mostXM, at.xM());
      leastZM = Math.min(leastZM, at.zM());
      mostZM = Math.max(mostZM, at.zM());
      if (steps < WATCH_STEPS) {
        return false;
      }
      steps = 0;
      double widthM = Math.max(mostXM - leastXM, mostZM - leastZM);
      return widthM < CAUGHT_STEPS * tuning.bendSpeedMPerS() * tuning.stepS();
    }
  }
}
