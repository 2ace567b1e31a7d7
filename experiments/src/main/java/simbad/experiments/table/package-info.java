/** Threshold tables that are computed rather than measured. */
@NullMarked
package simbad.experiments.table;

import org.jspecify.annotations.NullMarked;
