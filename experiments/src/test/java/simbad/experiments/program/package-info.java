/** Old programs as people write them, run from sources, classes and jars. */
@NullMarked
package simbad.experiments.program;

import org.jspecify.annotations.NullMarked;
