/** Constants that programs have fitted, in files with where they come from. */
@NullMarked
package simbad.gap.constants;

import org.jspecify.annotations.NullMarked;
