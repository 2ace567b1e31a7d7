/** Answers against sealed truths: names, verdicts, calibration, shrinkage, with intervals. */
@NullMarked
package simbad.blindworld.score;

import org.jspecify.annotations.NullMarked;
