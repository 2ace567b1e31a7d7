/** Tests. */
@NullMarked
package simbad.studio.bench;

import org.jspecify.annotations.NullMarked;
