/** Programs as users write them, in a package of their own. */
@NullMarked
package simbad.user;

import org.jspecify.annotations.NullMarked;
