/** The benchmark SRB-1: frozen orders of worlds, and what their bytes come to. */
@NullMarked
package simbad.blindworld.benchmark;

import org.jspecify.annotations.NullMarked;
