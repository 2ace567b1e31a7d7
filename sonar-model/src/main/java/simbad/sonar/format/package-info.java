/**
 * Files: threshold tables, sensors, scenes, rows of readings. Degrees and columns end here; inside
 * there are radians and values.
 *
 * <p>Every fault of a file is one {@link simbad.sonar.format.DataFormatException} that names the
 * file, the line and the field. Writers write beside the target and move, so that no half of a file
 * is ever seen.
 */
@NullMarked
package simbad.sonar.format;

import org.jspecify.annotations.NullMarked;
