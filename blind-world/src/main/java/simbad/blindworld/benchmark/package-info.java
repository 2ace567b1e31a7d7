/** The benchmark SRB-1: frozen orders of worlds, and what their bytes come to. */
package simbad.blindworld.benchmark;
