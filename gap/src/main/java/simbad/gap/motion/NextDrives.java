package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/**
 * Drives that would tell tied effects apart: of a few plain ones that of which the two say most.
 */
final class NextDrives {
  private static final double POSES_S = 0.2;
  private static final double HELD_S = 2;
  private static final int LEVELS = 8;

  /** Below it no drive of these tells the two apart. */
  private static final double LEAST_NATS = 1;

  private final double speed;
  private final double turn;

  NextDrives(CommandUse use) {
    speed = greatest(use.speeds(), 0.2);
    turn = greatest(use.turns(), 0.5);
  }

  private static double greatest(double[] sizes, double otherwise) {
    return sizes.length == 0 ? otherwise : sizes[sizes.length - 1];
  }

  /**
   * Returns the drive that tells most.
   *
   * @param one the most probable set
   * @param other the one with the rival in its place
   * @param separates names of the two
   */
  Optional<MotionDiagnosis.NextDrive> between(
      ScoredMotion one, ScoredMotion other, List<String> separates) {
    Optional<MotionDiagnosis.NextDrive> best = Optional.empty();
    for (List<Command> drive : drives()) {
      double nats = nats(drive, one, other);
      if (nats > LEAST_NATS
          && nats > best.map(MotionDiagnosis.NextDrive::expectedLogOdds).orElse(0.0)) {
        best = Optional.of(new MotionDiagnosis.NextDrive(separates, drive, nats));
      }
    }
    return best;
  }

  private static double nats(List<Command> drive, ScoredMotion one, ScoredMotion other) {
    List<TrackPose> poses = new ArrayList<>();
    double end = drive.get(drive.size() - 1).timeS() + HELD_S;
    for (int i = 0; i * POSES_S < end; i++) {
      poses.add(new TrackPose(i * POSES_S, 0, 0, 0));
    }
    MotionSteps given = new MotionSteps(List.of(new MotionRun("next", drive, poses)));
    double[][] first = given.expected(one.hypothesis().chain());
    double[][] second = given.expected(other.hypothesis().chain());
    double sum = 0;
    for (int c = 0; c < first.length; c++) {
      double[] apart = new double[first[c].length];
      for (int i = 0; i < apart.length; i++) {
        apart[i] = first[c][i] - second[c][i];
      }
      for (double z : new Whitening(given, one.fit().noises()[c], apart).of(apart)) {
        sum += z * z / 2;
      }
    }
    return sum;
  }

  /** Ladders of speeds, of turns, of both; stop and go; long ways straight on. */
  private List<List<Command>> drives() {
    Drive ladder = new Drive();
    Drive turns = new Drive();
    Drive both = new Drive();
    Drive stops = new Drive();
    Drive straight = new Drive();
    for (int i = 1; i <= LEVELS; i++) {
      double part = (double) i / LEVELS;
      double side = i % 2 == 0 ? 1 : -1;
      ladder.then(HELD_S, part * speed, 0);
      turns.then(HELD_S, 0, side * part * turn);
      both.then(HELD_S, part * speed, side * (1 - part / 2) * turn);
      stops.then(HELD_S * 0.6, part * speed, side * part * turn).then(HELD_S * 0.7, 0, 0);
      straight.then(2 * HELD_S, i <= LEVELS / 2 ? speed : speed / 3, 0);
    }
    return List.of(
        ladder.commands(),
        turns.commands(),
        both.commands(),
        stops.commands(),
        straight.commands());
  }

  private static final class Drive {
    private final List<Command> commands = new ArrayList<>();
    private double timeS;

    Drive then(double seconds, double speedMPerS, double turnRadPerS) {
      commands.add(new Command(timeS, speedMPerS, turnRadPerS));
      timeS += seconds;
      return this;
    }

    List<Command> commands() {
      commands.add(new Command(timeS, 0, 0));
      return commands;
    }
  }
}
