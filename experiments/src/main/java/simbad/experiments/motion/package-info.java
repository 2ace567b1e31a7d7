/** Motion folders out of others' logs, and what a diagnosis of motion leaves in its folder. */
@NullMarked
package simbad.experiments.motion;

import org.jspecify.annotations.NullMarked;
