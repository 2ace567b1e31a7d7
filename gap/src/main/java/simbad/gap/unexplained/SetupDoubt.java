package simbad.gap.unexplained;

import java.util.Optional;
import simbad.gap.calibrate.level.Leeway;

/** How far a set-up may itself be off. What is left over speaks for something else only beyond. */
public interface SetupDoubt {
  /** Returns how far the reference leaves a level law open; none under the threshold rule. */
  Optional<Leeway> leeway();

  /**
   * Returns by how much the sums over blocks of time vary more than by chance.
   *
   * @return first of echoes, then of ranges; at least 1 each
   */
  double[] blocksVary();

  /**
   * Returns by how much more than by chance the set-up itself is off in slices of a log.
   *
   * @param chance what misfits come to by chance, positive
   * @param rows of the log
   * @return at least 1
   */
  double misfitTimes(double chance, int rows);

  /** Returns by how much more the set-up's own gap is than it expects of itself, at least 1. */
  double gapTimes();

  /** Returns whether these are known from rows of a reference that were held out. */
  boolean isHeldOut();
}
