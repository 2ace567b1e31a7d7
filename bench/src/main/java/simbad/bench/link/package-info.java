/**
 * A serial line as the bench uses it: bytes out, bytes in with a time limit.
 *
 * <p>The only package that knows the native serial library. Knows no protocol.
 */
@NullMarked
package simbad.bench.link;

import org.jspecify.annotations.NullMarked;
