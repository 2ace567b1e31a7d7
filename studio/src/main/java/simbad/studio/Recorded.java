package simbad.studio;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;

/**
 * What was seen of a world before each of its steps. It keeps numbers, for to write them down takes
 * longer than a step: only what somebody looks at becomes text, and only then is asked why a sonar
 * heard nothing.
 */
final class Recorded {
  private static final int NO_ECHO = 0xFFFF;
  private static final long TEN_THOUSANDTHS = 10_000;

  private final int robots;
  private final double[] angles;
  private final List<Placement> placements = new ArrayList<>();
  private double[] poses = new double[0];
  private short[] rangesMm = new short[0];
  private int size;
  private int robotsTaken;

  /**
   * Prepares for a world.
   *
   * @param robots how many
   * @param angles of a robot's sonars, from its heading, radians
   */
  Recorded(int robots, double[] angles) {
    this.robots = robots;
    this.angles = angles.clone();
  }

  /** How many steps are on it. */
  int size() {
    return size;
  }

  /** Begins with the next step. */
  void begin(Placement obstacle) {
    if (poses.length < 3 * robots * (size + 1)) {
      int room = Math.max(1024, 2 * size);
      poses = Arrays.copyOf(poses, 3 * robots * room);
      rangesMm = Arrays.copyOf(rangesMm, angles.length * robots * room);
    }
    // One object stands for all steps in which nobody moves the obstacle.
    placements.add(obstacle);
    robotsTaken = 0;
    size++;
  }

  /** Takes where the next robot of the step is. */
  void pose(double xM, double zM, double headingRad) {
    int at = 3 * (robots * (size - 1) + robotsTaken++);
    poses[at] = xM;
    poses[at + 1] = zM;
    poses[at + 2] = headingRad;
  }

  /** Takes what a sonar of a robot read in the step; negative metres are no echo. */
  void range(int robot, int sonar, double rangeM) {
    long rangeMm = rangeM < 0 ? NO_ECHO : Math.min(NO_ECHO - 1, Math.round(1000 * rangeM));
    rangesMm[angles.length * (robots * (size - 1) + robot) + sonar] = (short) rangeMm;
  }

  /**
   * Writes a step as a JSON list: the first robot's x, z and heading, the obstacle's x, z and turn,
   * the first robot's ranges in mm, -1 for none, its reasons; of each further robot x, z, heading,
   * ranges and reasons.
   *
   * @param reasons of sonars that hear nothing, at any place of the obstacle
   */
  void write(StringBuilder text, int step, Reasons reasons) {
    Placement obstacle = placements.get(step);
    reasons.obstacleAt(obstacle);
    text.append('[');
    for (int robot = 0; robot < robots; robot++) {
      text.append(robot == 0 ? "" : ",");
      int at = 3 * (robots * step + robot);
      number(text, poses[at]).append(',');
      number(text, poses[at + 1]).append(',');
      number(text, poses[at + 2]);
      if (robot == 0) {
        number(text.append(','), obstacle.xM());
        number(text.append(','), obstacle.zM());
        number(text.append(','), obstacle.turnRad());
      }
      readings(text, step, robot, reasons);
    }
    text.append(']');
  }

  private void readings(StringBuilder text, int step, int robot, Reasons reasons) {
    for (int sonar = 0; sonar < angles.length; sonar++) {
      int rangeMm = rangeMm(step, robot, sonar);
      text.append(',').append(rangeMm == NO_ECHO ? -1 : rangeMm);
    }
    for (int sonar = 0; sonar < angles.length; sonar++) {
      boolean heard = rangeMm(step, robot, sonar) != NO_ECHO;
      text.append(',').append(heard ? Reasons.HEARD : reasons.of(looking(step, robot, sonar)));
    }
  }

  private int rangeMm(int step, int robot, int sonar) {
    return Short.toUnsignedInt(rangesMm[angles.length * (robots * step + robot) + sonar]);
  }

  private Pose looking(int step, int robot, int sonar) {
    int at = 3 * (robots * step + robot);
    return Pose.of(poses[at], poses[at + 1], poses[at + 2] + angles[sonar]);
  }

  /** To four decimals: a tenth of a millimetre. */
  private static StringBuilder number(StringBuilder text, double value) {
    long scaled = Math.round(TEN_THOUSANDTHS * value);
    text.append(scaled < 0 ? "-" : "").append(Math.abs(scaled) / TEN_THOUSANDTHS);
    long rest = Math.abs(scaled) % TEN_THOUSANDTHS;
    if (rest > 0) {
      text.append('.');
      for (long digit = TEN_THOUSANDTHS / 10; digit > 0 && rest > 0; digit /= 10) {
        text.append(rest / digit);
        rest %= digit;
      }
    }
    return text;
  }
}
