/** Tests of the pages of runs. */
@NullMarked
package simbad.figures.report;

import org.jspecify.annotations.NullMarked;
