package simbad.motion;

import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedDeque;
import simbad.sonar.check.Checks;

/**
 * How far a robot goes in given steps of one run, by one chain after another. It is what a {@link
 * Way} says, but for rounding. What chains have in common is computed once: a search changes one
 * value at a time. Several threads may ask at once.
 */
public final class DrivenSteps {
  private final Held commands;
  private final double startS;
  private final int size;

  /** Where steps begin and end on the grid. */
  private final double[] from;

  private final double[] to;

  /** What no thread works with now. */
  private final Deque<Kept> idle = new ConcurrentLinkedDeque<>();

  /** Takes what a model expects of the steps. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Takes one step.
     *
     * @param step its index
     * @param expected what the tracker would report
     */
    void take(int step, Displacement expected);
  }

  /**
   * Prepares the steps.
   *
   * @param run of which the commands are used, never the track
   * @param fromS where each step begins, not before the first command
   * @param toS where each ends, after its beginning
   */
  public DrivenSteps(MotionRun run, double[] fromS, double[] toS) {
    Checks.numbers("fromS", fromS);
    Checks.numbers("toS", toS);
    this.commands = Held.of(run.commands());
    startS = run.commands().get(0).timeS();
    size = Way.size(startS, Math.max(startS, Arrays.stream(toS).max().orElse(startS)));
    from = Arrays.stream(fromS).map(timeS -> Way.place(timeS, startS, size)).toArray();
    to = Arrays.stream(toS).map(timeS -> Way.place(timeS, startS, size)).toArray();
  }

  /**
   * Drives the run.
   *
   * @param chain how the robot moves
   * @param sink takes the steps in their order
   */
  public void drive(MotionChain chain, Sink sink) {
    Kept waiting = idle.poll();
    Kept kept = waiting == null ? new Kept() : waiting;
    Stages stages = Stages.of(chain);
    Leg leg = new Leg(stages, kept.means(stages, chain));
    Capture capture = chain.capture();
    for (int i = 0; i < from.length; i++) {
      sink.take(i, capture.of(leg.between(from[i], to[i])));
    }
    idle.push(kept);
  }

  /** What was commanded at the drive. */
  private record Asked(List<MotionChange> changes, double delayS) {}

  /** How speeds followed it. */
  private record Followed(Asked asked, List<Response> responses) {}

  /** The means of the chains that were driven last. */
  private final class Kept {
    private final RecentSeries<Asked> asked = new RecentSeries<>(size, this::ask);
    private final RecentSeries<Followed> followed =
        new RecentSeries<>(size, (key, into) -> into.follow(asked.of(key.asked), key.responses));

    CommandSeries means(Stages stages, MotionChain chain) {
      Asked key = new Asked(List.of(stages.commands()), chain.delayS());
      return followed.of(new Followed(key, chain.responses()));
    }

    private void ask(Asked key, CommandSeries into) {
      into.fill(commands.taken(key.changes), startS - key.delayS);
    }
  }
}
