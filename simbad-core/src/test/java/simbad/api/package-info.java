/** The committed list of Simbad's names, against what the classes have. */
@NullMarked
package simbad.api;

import org.jspecify.annotations.NullMarked;
