/** Tests. */
@NullMarked
package simbad.bench.link;

import org.jspecify.annotations.NullMarked;
