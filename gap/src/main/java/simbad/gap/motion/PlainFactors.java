package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.motion.Command;
import simbad.motion.MotionChange;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/**
 * What changes of commands are to a log's commands. Where a robot is told few speeds, steps, limits
 * and dead bands can do to them just what factors of speed and of turning do: told 0.1, 0.2 and 0.3
 * m/s, steps of 0.0475 m/s make 0.095, 0.19 and 0.285. A change that is two such factors counts as
 * two causes, as the factors do.
 */
final class PlainFactors {
  /**
   * A share of the squared change: what is off by less than a fifth of it is hardly another one.
   */
  private static final double OTHER = 0.05;

  /** Half a practical change of a scale. */
  private static final double LITTLE = 0.005;

  /** Of each factor that is made in another way: a likelihood ratio of 7 for the plainer. */
  private static final double LESS_PLAIN_NATS = 2;

  private final List<Asked> held = new ArrayList<>();

  /**
   * A command and how long it was held.
   *
   * @param command what was asked for
   * @param seconds until the next one
   */
  private record Asked(Command command, double seconds) {}

  /**
   * Looks through commands.
   *
   * @param runs with the commands
   */
  PlainFactors(List<MotionRun> runs) {
    for (MotionRun run : runs) {
      List<Command> commands = run.commands();
      for (int i = 0; i + 1 < commands.size(); i++) {
        held.add(new Asked(commands.get(i), commands.get(i + 1).timeS() - commands.get(i).timeS()));
      }
    }
  }

  /**
   * Returns what a set must gain to be as probable as none, nats: its effects and each second
   * factor cost alike, and of what does the same the plainer is likelier.
   */
  double costNats(MotionHypothesis set) {
    double cost = Odds.COST_NATS * set.effects().size();
    for (MotionChange change : set.changes()) {
      int factors = factors(change);
      cost += Odds.COST_NATS * Math.max(0, factors - 1) + LESS_PLAIN_NATS * factors;
    }
    return cost;
  }

  /** Tells whether a set has no change that is factors only, which a plainer set would have. */
  boolean isPlain(MotionHypothesis set) {
    return set.changes().stream().noneMatch(this::isFactors);
  }

  /** Tells whether a change is factors, of speed or of turning, and nothing else that matters. */
  boolean isFactors(MotionChange change) {
    List<Sums> channels = channels(change);
    return channels.stream().anyMatch(Sums::isFactor)
        && channels.stream().allMatch(one -> one.isFactor() || !one.isChanged());
  }

  /** Returns the scales of what a change of commands changes: of speed, of turning, or both. */
  List<MotionForm> scales(MotionChange change) {
    List<Sums> channels = channels(change);
    return IntStream.range(0, channels.size())
        .filter(i -> channels.get(i).isChanged())
        .mapToObj(MotionForms.SCALES::get)
        .toList();
  }

  /** Returns in how many of speed and turning a change is a factor; 0 where it is none of these. */
  private int factors(MotionChange change) {
    List<Sums> channels = channels(change);
    return (int) channels.stream().filter(Sums::isFactor).count();
  }

  private List<Sums> channels(MotionChange change) {
    Sums speed = new Sums();
    Sums turn = new Sums();
    if (!change.remembers()) {
      for (Asked one : held) {
        Command asked = one.command;
        Command driven = change.commanded(asked);
        speed.add(asked.speedMPerS(), driven.speedMPerS(), one.seconds);
        turn.add(asked.turnRadPerS(), driven.turnRadPerS(), one.seconds);
      }
    }
    return List.of(speed, turn);
  }

  /** Weighted squares and products of what was asked and what is driven. */
  private static final class Sums {
    private double asked;
    private double both;
    private double driven;
    private double changed;

    void add(double from, double to, double seconds) {
      asked += from * from * seconds;
      both += from * to * seconds;
      driven += to * to * seconds;
      changed += (to - from) * (to - from) * seconds;
    }

    /** Tells whether it is changed so much that a scale of that size would matter. */
    boolean isChanged() {
      return changed > LITTLE * LITTLE * asked;
    }

    /** Tells whether it is changed, and by a factor alone. */
    boolean isFactor() {
      return isChanged() && driven - both * both / asked <= OTHER * changed;
    }
  }
}
