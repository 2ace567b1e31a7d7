/** Tests. */
@NullMarked
package simbad.bench.session;

import org.jspecify.annotations.NullMarked;
