/** The files, pictures and pages that a run leaves behind. The same results give the same bytes. */
@NullMarked
package simbad.experiments.report;

import org.jspecify.annotations.NullMarked;
