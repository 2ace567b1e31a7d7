/** Pictures and pages of runs, and the pictures of tables. */
@NullMarked
package simbad.figures.report;

import org.jspecify.annotations.NullMarked;
