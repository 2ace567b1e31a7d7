/** Tests of the ranger's protocol. */
@NullMarked
package simbad.bench.protocol;

import org.jspecify.annotations.NullMarked;
