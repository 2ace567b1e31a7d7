/** What numbers have to be wherever something is made of them. Knows nothing of this program. */
@NullMarked
package simbad.blindworld.check;

import org.jspecify.annotations.NullMarked;
