/** Tests of the simulated board, most of them with the real program in gpsim. */
@NullMarked
package simbad.bench.board;

import org.jspecify.annotations.NullMarked;
