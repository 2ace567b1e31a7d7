/**
 * Makes cases: draws truths, has worlds read, writes data sets and, apart from them, sealed truths.
 */
@NullMarked
package simbad.blindworld.generate;

import org.jspecify.annotations.NullMarked;
