/**
 * The live page: a robot, its belt and an obstacle that a browser shows, plays and moves.
 *
 * <p>Steps worlds with the code of {@code simbad.experiments.run}; nothing here decides what a
 * sensor reads. May not know: the command line's package.
 */
@NullMarked
package simbad.studio;

import org.jspecify.annotations.NullMarked;
