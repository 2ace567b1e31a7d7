/** Motion folders: robot.json, commands.csv and track.csv, as gap/FORMAT.md has them. */
@NullMarked
package simbad.motion.format;

import org.jspecify.annotations.NullMarked;
