package simbad.blindworld.motion;

import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;

/**
 * Something that makes a robot move, or a tracker see, otherwise than the simulator believes.
 *
 * @param stage where on the way from the command to the track it acts
 * @param heard what becomes of the commands of a run
 * @param begin what acts in a repeat, with chance of its own
 */
public record MotionChange(
    Stage stage,
    BiFunction<Commands, RandomGenerator, Commands> heard,
    Function<RandomGenerator, Acting> begin) {

  private static final Acting NOTHING = new Acting() {};

  /** Where a change acts; earlier ones come first. */
  public enum Stage {
    /** What is told. */
    COMMAND,
    /** When it acts. */
    TIME,
    /** How speeds approach what is told. */
    ACTUATION,
    /** What wheels make of their speeds. */
    WHEEL,
    /** Turning by itself. */
    TURNING,
    /** Chance on the floor. */
    CHANCE,
    /** What is seen. */
    TRACK
  }

  /** Each command by itself. */
  public static MotionChange commands(UnaryOperator<Commands.Speeds> rule) {
    return heard(Stage.COMMAND, (commands, random) -> commands.each(rule));
  }

  /** All commands of a run together. */
  public static MotionChange heard(
      Stage stage, BiFunction<Commands, RandomGenerator, Commands> heard) {
    return new MotionChange(stage, heard, random -> NOTHING);
  }

  /** What happens in a repeat. */
  public static MotionChange acting(Stage stage, Function<RandomGenerator, Acting> begin) {
    return new MotionChange(stage, (commands, random) -> commands, begin);
  }

  /** Each step by itself, without chance or memory. */
  public static MotionChange steps(Stage stage, Consumer<Step> rule) {
    return acting(stage, random -> moving(rule));
  }

  /** Each frame by itself, without chance or memory. */
  public static MotionChange frames(Consumer<Sight> rule) {
    return acting(
        Stage.TRACK,
        random ->
            new Acting() {
              @Override
              public void see(Sight sight) {
                rule.accept(sight);
              }
            });
  }

  /** What acts on steps only. */
  public static Acting moving(Consumer<Step> rule) {
    return new Acting() {
      @Override
      public void move(Step step) {
        rule.accept(step);
      }
    };
  }

  /** Commands that all act late by the same time. */
  public static MotionChange latency(double byS) {
    Checks.finite("latency", byS);
    return heard(Stage.TIME, (commands, random) -> commands.later(byS));
  }
}
