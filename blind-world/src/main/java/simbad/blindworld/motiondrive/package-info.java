/** Who is driven how before which camera: robots, drives, trackers, drawn by chance. */
@NullMarked
package simbad.blindworld.motiondrive;

import org.jspecify.annotations.NullMarked;
