/**
 * The one command line: parses, calls what does the work, and says how it went.
 *
 * <p>Exit statuses, the standard streams and the catch of the unforeseen are here and nowhere else.
 * Nothing outside this package may use it.
 */
@NullMarked
package simbad.cli;

import org.jspecify.annotations.NullMarked;
