package simbad.experiments.fleet;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import simbad.experiments.run.SensorKind;
import simbad.sonar.sensing.Readings;

/**
 * Robots that are stepped together, each in a world of its own: none hears or meets another. What
 * goes in and comes out lies in direct buffers in the machine's byte order, a row for each robot,
 * so that a caller in another language shares them.
 *
 * <p>Every robot has its own chance: what one does hangs neither on the others nor on how many
 * threads step them. Not safe for use by several threads.
 */
public final class Fleet {
  /** Columns of {@link #commands()}: speed ahead in m/s, turn rate in rad/s counter-clockwise. */
  public static final int COMMANDS = 2;

  /** Columns of {@link #poses()}: x, z, heading (m, m, rad), distance from the edge in metres. */
  public static final int POSES = 4;

  /** What it costs to run into an obstacle, in turns round it. */
  private static final double PENALTY = 1;

  /** Fewer are stepped sooner by one thread. */
  private static final int LEAST_FOR_THREADS = 8;

  private final FleetSetup setup;
  private final Autoreset autoreset;
  private final FleetRobot[] robots;
  private final EdgeGain[] gains;
  private final DoubleBuffer commands;
  private final FloatBuffer readings;
  private final FloatBuffer lastReadings;
  private final DoubleBuffer rewards;
  private final DoubleBuffer poses;
  private final DoubleBuffer lastPoses;
  private final ByteBuffer terminated;
  private final ByteBuffer truncated;

  /**
   * Creates robots that have not started; {@link #start} or {@link #startAt} starts each.
   *
   * @param setup what each finds
   * @param size how many, at least 1
   * @param autoreset when the next episode begins
   */
  public Fleet(FleetSetup setup, int size, Autoreset autoreset) {
    if (size < 1) {
      throw new IllegalArgumentException("size = " + size + " is not at least 1");
    }
    this.setup = setup;
    this.autoreset = autoreset;
    robots = new FleetRobot[size];
    gains = new EdgeGain[size];
    for (int i = 0; i < size; i++) {
      robots[i] = new FleetRobot(setup);
      gains[i] = new EdgeGain(setup.circled().thresholds().table());
    }
    commands = bytes(size * COMMANDS * Double.BYTES).asDoubleBuffer();
    readings = bytes(size * SensorKind.SONARS * Float.BYTES).asFloatBuffer();
    lastReadings = bytes(size * SensorKind.SONARS * Float.BYTES).asFloatBuffer();
    rewards = bytes(size * Double.BYTES).asDoubleBuffer();
    poses = bytes(size * POSES * Double.BYTES).asDoubleBuffer();
    lastPoses = bytes(size * POSES * Double.BYTES).asDoubleBuffer();
    terminated = bytes(size);
    truncated = bytes(size);
  }

  private static ByteBuffer bytes(int size) {
    return ByteBuffer.allocateDirect(size).order(ByteOrder.nativeOrder());
  }

  /** Returns what stands in the place of no echo, metres. */
  public double noEchoM() {
    return setup.noEchoM();
  }

  /** Returns the number of robots. */
  public int size() {
    return robots.length;
  }

  /** Returns what the robots are told in the next step, {@value #COMMANDS} numbers each. */
  public DoubleBuffer commands() {
    return commands;
  }

  /** Returns what the sonars read, {@value SensorKind#SONARS} metres for each robot. */
  public FloatBuffer readings() {
    return readings;
  }

  /** Returns what was read at the end of episodes that ended in the latest step. */
  public FloatBuffer lastReadings() {
    return lastReadings;
  }

  /** Returns what the latest step was worth. */
  public DoubleBuffer rewards() {
    return rewards;
  }

  /** Returns where the robots are, {@value #POSES} numbers each. */
  public DoubleBuffer poses() {
    return poses;
  }

  /** Returns where robots were at the end of episodes that ended in the latest step. */
  public DoubleBuffer lastPoses() {
    return lastPoses;
  }

  /** Returns 1 for each robot that an obstacle stopped in the latest step, 0 for the others. */
  public ByteBuffer terminated() {
    return terminated;
  }

  /** Returns 1 for each robot whose episode was long enough with the latest step. */
  public ByteBuffer truncated() {
    return truncated;
  }

  /**
   * Gives a robot its chance from its next start on.
   *
   * @param robot from 0
   */
  public void seed(int robot, long seed) {
    robots[robot].seed(seed);
  }

  /**
   * Begins an episode at a place by chance.
   *
   * @param robot from 0
   */
  public void start(int robot) {
    robots[robot].start();
    begin(robot);
  }

  /**
   * Begins an episode at a given place.
   *
   * @param robot from 0
   * @param xM metres; the obstacle that is circled is at the origin
   * @param zM metres
   * @param headingRad counter-clockwise from +x as seen from above
   */
  public void startAt(int robot, double xM, double zM, double headingRad) {
    robots[robot].startAt(xM, zM, headingRad);
    begin(robot);
  }

  private void begin(int robot) {
    gains[robot].start(robots[robot].xM(), robots[robot].zM());
    end(robot, 0, false, false);
    read(robot, readings);
  }

  /**
   * Steps every robot once by its command, {@link simbad.experiments.run.Circuit#STEP_S} long.
   *
   * @throws IllegalArgumentException if a command is NaN; some robots may have moved then
   */
  public void step() {
    IntStream all = IntStream.range(0, robots.length);
    IntConsumer one = this::step;
    if (robots.length < LEAST_FOR_THREADS) {
      all.forEach(one);
    } else {
      all.parallel().forEach(one);
    }
  }

  /**
   * Steps so many times by the same commands.
   *
   * @param times at least 0
   */
  public void repeat(int times) {
    for (int i = 0; i < times; i++) {
      step();
    }
  }

  private void step(int robot) {
    if (terminated.get(robot) + truncated.get(robot) > 0) {
      if (autoreset == Autoreset.NEXT_STEP) {
        start(robot);
      }
      if (autoreset != Autoreset.SAME_STEP) {
        return;
      }
    }
    FleetRobot moved = robots[robot];
    moved.step(
        cut(commands.get(COMMANDS * robot), setup.mostMPerS()),
        cut(commands.get(COMMANDS * robot + 1), setup.mostRadPerS()));
    boolean isStopped = moved.isStoppedByObstacle();
    double gain = gains[robot].moved(moved.xM(), moved.zM()) - (isStopped ? PENALTY : 0);
    boolean isLong = moved.isAtItsEnd();
    if (autoreset == Autoreset.SAME_STEP && (isStopped || isLong)) {
      read(robot, lastReadings);
      locate(robot, lastPoses);
      start(robot);
    } else {
      read(robot, readings);
    }
    end(robot, gain, isStopped, isLong);
  }

  private static double cut(double commanded, double most) {
    if (Double.isNaN(commanded)) {
      throw new IllegalArgumentException("a command is NaN, expected a number");
    }
    return Math.max(-most, Math.min(most, commanded));
  }

  private void end(int robot, double gain, boolean isStopped, boolean isLong) {
    rewards.put(robot, gain);
    terminated.put(robot, (byte) (isStopped ? 1 : 0));
    truncated.put(robot, (byte) (isLong ? 1 : 0));
    locate(robot, poses);
  }

  private void locate(int robot, DoubleBuffer into) {
    FleetRobot at = robots[robot];
    into.put(POSES * robot, at.xM());
    into.put(POSES * robot + 1, at.zM());
    into.put(POSES * robot + 2, at.getHeadingRad());
    into.put(POSES * robot + 3, gains[robot].distanceM());
  }

  private void read(int robot, FloatBuffer into) {
    Readings heard = robots[robot].readings();
    for (int i = 0; i < SensorKind.SONARS; i++) {
      double rangeM = heard.isEcho(i) ? heard.rangeM(i) : setup.noEchoM();
      into.put(SensorKind.SONARS * robot + i, (float) Math.min(rangeM, setup.noEchoM()));
    }
  }
}
