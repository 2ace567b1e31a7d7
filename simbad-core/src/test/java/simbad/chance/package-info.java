/** Small programs made by chance, run under several switches and compared. */
@NullMarked
package simbad.chance;

import org.jspecify.annotations.NullMarked;
