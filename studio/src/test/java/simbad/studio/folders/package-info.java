/** Tests. */
@NullMarked
package simbad.studio.folders;

import org.jspecify.annotations.NullMarked;
