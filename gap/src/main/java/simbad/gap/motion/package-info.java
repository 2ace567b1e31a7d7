/**
 * The diagnosis of motion: windows of a log, fits of chains of motion effects, their search and
 * check on blocks that were not fitted, what no effect explains. Knows no sensor.
 */
@NullMarked
package simbad.gap.motion;

import org.jspecify.annotations.NullMarked;
