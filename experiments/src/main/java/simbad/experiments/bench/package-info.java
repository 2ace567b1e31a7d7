/**
 * Captures as files: a folder with journal and data set, and the sweep before the simulated board.
 */
@NullMarked
package simbad.experiments.bench;

import org.jspecify.annotations.NullMarked;
