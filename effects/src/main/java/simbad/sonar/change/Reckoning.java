package simbad.sonar.change;

import java.util.Map;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PoseChange;
import simbad.sonar.ping.TruePose;

/**
 * A robot that reckons its poses from its wheels goes another way than it believes: each piece of
 * its way is laid anew from where the one before ends. It changes what rows of a log mean; a sensor
 * on a robot that drives hears from where the robot is.
 *
 * @param way true over believed length; 1 is neutral
 * @param turn true over believed turn; 1 is neutral
 * @param radPerS what it turns by besides, for each second; 0 is neutral
 * @param radPerM the same for each metre of true way; 0 is neutral
 * @param robotFromSensor mounts by the sensors' labels; a sensor without one is the robot's centre
 */
public record Reckoning(
    double way, double turn, double radPerS, double radPerM, Map<String, Placement> robotFromSensor)
    implements PoseChange {
  /** Checks the figures; NaN is refused. */
  public Reckoning {
    Checks.notNegative("way", way);
    Checks.notNegative("turn", turn);
    Checks.finite("radPerS", radPerS);
    Checks.finite("radPerM", radPerM);
    robotFromSensor = Map.copyOf(robotFromSensor);
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    boolean neutral = way == 1 && turn == 1 && radPerS == 0 && radPerM == 0;
    return neutral
        ? Track.STILL
        : new Anew(robotFromSensor.getOrDefault(sensor, Placement.IDENTITY));
  }

  private final class Anew implements Track {
    private final Placement mount;
    private final TruePose believed = new TruePose();
    private final TruePose robot = new TruePose();
    private double timeS;
    private boolean started;

    Anew(Placement mount) {
      this.mount = mount;
    }

    @Override
    public void next(double nowS, TruePose pose) {
      double headingRad = pose.headingRad() - mount.turnRad();
      double xM = pose.xM() - eastM(headingRad);
      double zM = pose.zM() - southM(headingRad);
      if (started) {
        go(xM - believed.xM(), zM - believed.zM(), headingRad, nowS - timeS);
      } else {
        robot.set(xM, zM, headingRad);
        started = true;
      }
      believed.set(xM, zM, headingRad);
      timeS = nowS;
      pose.set(
          robot.xM() + eastM(robot.headingRad()),
          robot.zM() + southM(robot.headingRad()),
          robot.headingRad() + mount.turnRad());
    }

    /** A piece of way keeps its place to the heading at its middle. */
    private void go(double dx, double dz, double headingRad, double seconds) {
      double turned = Angles.signed(headingRad - believed.headingRad());
      double middle = believed.headingRad() + turned / 2;
      double along = dx * Math.cos(middle) - dz * Math.sin(middle);
      double by = turn * turned + radPerS * seconds + radPerM * way * along;
      double angle = robot.headingRad() + by / 2 - middle;
      robot.set(
          robot.xM() + way * (dx * Math.cos(angle) + dz * Math.sin(angle)),
          robot.zM() + way * (dz * Math.cos(angle) - dx * Math.sin(angle)),
          robot.headingRad() + by);
    }

    /** How far the sensor is from the robot's centre towards x. */
    private double eastM(double headingRad) {
      return mount.xM() * Math.cos(headingRad) + mount.zM() * Math.sin(headingRad);
    }

    private double southM(double headingRad) {
      return mount.zM() * Math.cos(headingRad) - mount.xM() * Math.sin(headingRad);
    }
  }
}
