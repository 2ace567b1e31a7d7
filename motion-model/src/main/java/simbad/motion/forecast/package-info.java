/**
 * What a model of motion expects of windows of a log, as distributions. A forecast sees commands
 * and never the track; where the track is known only decides which windows there are.
 */
@NullMarked
package simbad.motion.forecast;

import org.jspecify.annotations.NullMarked;
