/** Tests of the live page, most of them in a browser. */
@NullMarked
package simbad.studio;

import org.jspecify.annotations.NullMarked;
