/**
 * The main experiment: a robot circles an obstacle at the limit of detection, once per sensor; its
 * trace is compared with the obstacle's threshold table.
 *
 * <p>Values in, values out; the files and pictures of a run are written here too, the console is
 * not touched.
 */
@NullMarked
package simbad.experiments.run;

import org.jspecify.annotations.NullMarked;
