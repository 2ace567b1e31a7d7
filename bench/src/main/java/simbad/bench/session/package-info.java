/**
 * A conversation with the ranger over a line: who it is, one ping at a time, and what to do when it
 * is disturbed.
 *
 * <p>Knows no file and no obstacle.
 */
@NullMarked
package simbad.bench.session;

import org.jspecify.annotations.NullMarked;
