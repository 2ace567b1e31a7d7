package simbad.bench.capture;

import java.util.List;
import java.util.Optional;

/**
 * Says which distance to try next at a bearing, from what was heard so far and nothing else, so
 * that a sweep goes on after any interruption where it was.
 *
 * <p>First the threshold is bracketed by halving; then the obstacle goes out step by step until the
 * echo is lost twice in a row, and comes in again until it is back twice in a row: the two edges
 * differ where there is hysteresis. Distances are whole steps.
 */
public final class LadderSearch {
  /** So many steps the ladder begins before the bracket. */
  private static final int MARGIN = 3;

  /** One level may be odd by chance; two in a row are not. */
  private static final int IN_A_ROW = 2;

  private final SweepPlan plan;
  private final int near;
  private final int far;

  /** Prepares for a plan. */
  public LadderSearch(SweepPlan plan) {
    this.plan = plan;
    near = (int) Math.ceil(plan.nearM() / plan.stepM() - 1e-9);
    far = (int) Math.floor(plan.farM() / plan.stepM() + 1e-9);
  }

  /**
   * Returns what to try next.
   *
   * @param levels of this bearing in the order in which they were taken; the last one may want
   *     pings yet
   * @return empty when the bearing is done
   */
  public Optional<TriedDistance> next(List<Level> levels) {
    if (!levels.isEmpty()) {
      Level last = levels.get(levels.size() - 1);
      if (!plan.isWhole(last)) {
        return Optional.of(new TriedDistance(last.distanceM(), last.approach()));
      }
    }
    int[] bracket = bracket(levels);
    if (bracket[1] - bracket[0] > 1) {
      return probe((bracket[0] + bracket[1]) / 2, Approach.SEARCH);
    }
    return ladder(levels, bracket);
  }

  /** The last step heard and the first one lost, as far as the search has come. */
  private int[] bracket(List<Level> levels) {
    int heard = near - 1;
    int lost = far + 1;
    for (Level level : levels) {
      if (level.approach() == Approach.SEARCH) {
        if (plan.isLost(level)) {
          lost = Math.min(lost, step(level));
        } else {
          heard = Math.max(heard, step(level));
        }
      }
    }
    return new int[] {heard, lost};
  }

  private Optional<TriedDistance> ladder(List<Level> levels, int[] bracket) {
    List<Level> out = of(levels, Approach.OUT);
    if (!endsWith(out, true)) {
      int next = out.isEmpty() ? bracket[0] - MARGIN : step(out.get(out.size() - 1)) + 1;
      if (next <= far) {
        return probe(Math.max(near, next), Approach.OUT);
      }
    }
    List<Level> in = of(levels, Approach.IN);
    if (!endsWith(in, false)) {
      int next = in.isEmpty() ? furthest(out) : step(in.get(in.size() - 1)) - 1;
      if (next >= near) {
        return probe(Math.min(far, next), Approach.IN);
      }
    }
    return Optional.empty();
  }

  private static List<Level> of(List<Level> levels, Approach approach) {
    return levels.stream().filter(level -> level.approach() == approach).toList();
  }

  private boolean endsWith(List<Level> levels, boolean lost) {
    int size = levels.size();
    return size >= IN_A_ROW
        && levels.subList(size - IN_A_ROW, size).stream()
            .allMatch(level -> plan.isLost(level) == lost);
  }

  private int furthest(List<Level> out) {
    return out.stream().mapToInt(this::step).max().orElse(far) + 1;
  }

  private int step(Level level) {
    return (int) Math.round(level.distanceM() / plan.stepM());
  }

  private Optional<TriedDistance> probe(int step, Approach approach) {
    // Rounded to a tenth of a millimetre: a journal gives back the same number.
    return Optional.of(new TriedDistance(Math.rint(step * plan.stepM() * 1e4) / 1e4, approach));
  }
}
