/** Tests on a real cluster of processes. */
@NullMarked
package simbad.cluster;

import org.jspecify.annotations.NullMarked;
