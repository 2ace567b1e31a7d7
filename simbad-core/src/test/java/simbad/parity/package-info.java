/** Traces of the original Simbad, reproduced through the public names only, as a program would. */
@NullMarked
package simbad.parity;

import org.jspecify.annotations.NullMarked;
