/** The page that shows a sweep while it goes on. */
@NullMarked
package simbad.studio.bench;

import org.jspecify.annotations.NullMarked;
