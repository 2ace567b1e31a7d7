/**
 * A sweep of detection thresholds: which distance to try next, what counts as lost, the journal
 * that keeps every reading, and the table that comes of it.
 *
 * <p>Knows no port and no terminal: those are given to it.
 */
@NullMarked
package simbad.bench.capture;

import org.jspecify.annotations.NullMarked;
