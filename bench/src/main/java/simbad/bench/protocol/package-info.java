/**
 * What the ranger's firmware and the bench say to each other: the table of words and codes, and the
 * lines of frame mode.
 *
 * <p>Texts in, values out: this package knows no port and no board.
 */
@NullMarked
package simbad.bench.protocol;

import org.jspecify.annotations.NullMarked;
