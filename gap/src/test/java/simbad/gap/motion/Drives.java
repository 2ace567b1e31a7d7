package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;

/**
 * Drives of a robot that is simulated here, in steps of two milliseconds and without the product's
 * model: what it does to commands is said field by field.
 */
final class Drives {
  static final double SIGMA_M = 0.001;
  static final double SIGMA_RAD = Math.toRadians(0.2);
  private static final double DT = 0.002;
  private static final int PER_POSE = 25;

  double seconds = 150;
  double speedFactor = 1;
  double turnFactor = 1;
  double turnBias;
  double turnPerMetre;
  double lateS;
  double clockS;
  boolean separateClocks;
  double lagS;
  double acceleration = Double.POSITIVE_INFINITY;
  double deadSpeed;
  double deadTurn;
  double mostSpeed = Double.POSITIVE_INFINITY;
  double mostTurn = Double.POSITIVE_INFINITY;

  /** Speed that a radian per second of turning takes from the greatest one. */
  double lostPerTurn;

  double speedStep;
  double turnStep;
  double forwardM;
  double leftM;
  double trackerTurned;

  /** Of the speed, over a square root of a second. */
  double roughness;

  /** Slips a minute, each of half a second and most of the way. */
  double slips;

  /** Share of the speed by which it goes faster one way and slower the other. */
  double slope;

  /** Share of the speed that is gone in the end. */
  double sag;

  /** Each command acts later by up to so much, evenly. */
  double unsteadyS;

  /** Speed that friction takes from every command. */
  double lessSpeed;

  /** Steps of the speed, the next towards rest. */
  double cutStep;

  /** Share by which a wheel out of round goes faster and slower, once in 20 cm. */
  double ripple;

  /** Share by which turns to the left are larger, and to the right smaller. */
  double oneSided;

  /** Speeds bend towards it, infinite for none: by a hyperbolic tangent above half of it. */
  double softSpeed = Double.POSITIVE_INFINITY;

  /** By how much the right wheel is larger, on a base of 20 cm; the left one is as it should be. */
  double rightWheel;

  /** Share by which turns are larger or smaller for a second at a time. */
  double unsteadyTurns;

  /** Commands in a minute that are not followed. */
  double dropped;

  /** What is sent in every second stretch of six seconds acts later by so much. */
  double clogS;

  /** Every second command goes backwards. */
  boolean backwards;

  /** Turn by which casters push it aside in the half second after it has turned back. */
  double kick;

  /** Steps of the speeds that are asked for; 0 for any speed. */
  double askedStep;

  /** Share of commands that are one and the same. */
  boolean oneSpeed;

  /** Rates of turning that are asked for; none for any rate. */
  double[] askedTurns = {};

  private final SplittableRandom random;

  Drives(long seed) {
    random = new SplittableRandom(seed);
  }

  MotionData data() {
    List<Command> commands = commands();
    Robot robot = new Robot(false, 0, separateClocks, SIGMA_M, SIGMA_RAD, MotionChain.EXACT);
    MotionRun run = new MotionRun("a", commands, track(commands));
    return new MotionData("drive", robot, List.of(run), List.of());
  }

  private List<Command> commands() {
    List<Command> commands = new ArrayList<>();
    for (double t = 0; t < seconds; t += 0.8 + 2 * random.nextDouble()) {
      double kind = random.nextDouble();
      double speed = oneSpeed ? 0.2 : 0.01 + 0.29 * random.nextDouble();
      speed = backwards && commands.size() % 2 > 0 ? -speed : speed;
      speed = askedStep > 0 ? askedStep * Math.ceil(speed / askedStep) : speed;
      double turn = 2 * random.nextDouble() - 1;
      int turns = askedTurns.length;
      turn = turns > 0 ? askedTurns[(int) (turns * (turn + 1) / 2)] : turn;
      if (kind < 0.15) {
        commands.add(new Command(t, 0, 0));
      } else if (kind < 0.3) {
        commands.add(new Command(t, 0, turn));
      } else if (kind < 0.6) {
        commands.add(new Command(t, speed, 0));
      } else {
        commands.add(new Command(t, speed, turn));
      }
    }
    return commands;
  }

  private List<TrackPose> track(List<Command> commands) {
    List<TrackPose> track = new ArrayList<>();
    double x = 0;
    double y = 0;
    double heading = 0.3;
    double v = 0;
    double w = 0;
    double slipsUntil = -1;
    double waitsS = 0;
    double wheel = 0;
    double wanders = 0;
    double before = 0;
    double kickedUntil = -1;
    int at = -1;
    Command now = new Command(0, 0, 0);
    for (int i = 0; i * DT < seconds; i++) {
      double t = i * DT;
      if (i % PER_POSE == 0) {
        track.add(seen(t, x, y, heading));
      }
      while (at + 1 < commands.size() && actsS(commands.get(at + 1)) <= t - waitsS) {
        at++;
        waitsS = unsteadyS > 0 ? unsteadyS * random.nextDouble() : 0;
        now = random.nextDouble() < dropped ? now : commands.get(at);
      }
      double left = Math.max(0, mostSpeed - lostPerTurn * Math.abs(now.turnRadPerS()));
      double asked = driven(now.speedMPerS(), deadSpeed, left, speedStep);
      v = followed(v, bent(less(asked)), acceleration);
      w = followed(w, driven(now.turnRadPerS(), deadTurn, mostTurn, turnStep), 5 * acceleration);
      if (kick != 0 && v != 0) {
        kickedUntil = v * before < 0 ? t + 0.5 : kickedUntil;
        before = v;
      }
      if (random.nextDouble() < slips / 60 * DT && v != 0) {
        slipsUntil = t + 0.5;
      }
      double ground = v * speedFactor * (t < slipsUntil ? 0.3 : 1) * (1 - sag * t / seconds);
      wheel += ground * DT;
      ground *= 1 + ripple * Math.cos(2 * Math.PI * wheel / 0.2);
      ground *= 1 + slope * Math.cos(heading - 0.7);
      double rim = ground + w * turnFactor * 0.1;
      ground += rightWheel * rim / 2;
      if (unsteadyTurns > 0 && i % 500 == 0) {
        wanders = unsteadyTurns * random.nextGaussian();
      }
      double scatter = roughness * Math.sqrt(Math.abs(v) * DT);
      double way = ground * DT + scatter * random.nextGaussian();
      double turn =
          (w * turnFactor * (1 + Math.signum(w) * oneSided) + turnBias + turnPerMetre * ground)
              * (1 + wanders)
              * DT;
      turn += rightWheel * rim / 0.2 * DT + (t < kickedUntil ? kick / 0.5 * DT : 0);
      turn += 5 * scatter * random.nextGaussian();
      x += way * Math.cos(heading + turn / 2);
      y += way * Math.sin(heading + turn / 2);
      heading += turn;
    }
    return track;
  }

  private double actsS(Command command) {
    return command.timeS() + lateS + (command.timeS() % 12 < 6 ? clogS : 0);
  }

  private static double driven(double command, double dead, double most, double step) {
    double size = Math.abs(command) < dead ? 0 : Math.min(most, Math.abs(command));
    return Math.copySign(step > 0 ? step * Math.rint(size / step) : size, command);
  }

  private double less(double speed) {
    double left = Math.max(0, Math.abs(speed) - lessSpeed);
    return Math.copySign(cutStep > 0 ? Math.floor(left / cutStep) * cutStep : left, speed);
  }

  private double bent(double speed) {
    double half = softSpeed / 2;
    return speed > half ? half + half * Math.tanh((speed - half) / half) : speed;
  }

  private double followed(double now, double target, double most) {
    double wanted = lagS > 0 ? now + (target - now) * DT / lagS : target;
    double by = wanted - now;
    return Math.abs(by) > most * DT ? now + Math.copySign(most * DT, by) : wanted;
  }

  private TrackPose seen(double t, double x, double y, double heading) {
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    double direction = heading + trackerTurned + SIGMA_RAD * random.nextGaussian();
    return new TrackPose(
        t + clockS,
        x + forwardM * cos - leftM * sin + SIGMA_M * random.nextGaussian(),
        y + forwardM * sin + leftM * cos + SIGMA_M * random.nextGaussian(),
        Math.IEEEremainder(direction, 2 * Math.PI));
  }
}
