/**
 * The main experiment: a robot circles an obstacle at the limit of detection, once per sensor; its
 * trace is compared with the obstacle's threshold table.
 *
 * <p>Values in, values out: files and pictures are made of them by {@code
 * simbad.experiments.report}.
 */
@NullMarked
package simbad.experiments.run;

import org.jspecify.annotations.NullMarked;
