/**
 * A threshold table predicted from a cross-section: how a rigid body scatters 40 kHz in air, and at
 * which distance a sonar just loses the echo. Knows shapes and tables, no world and no files.
 */
@NullMarked
package simbad.scattering;

import org.jspecify.annotations.NullMarked;
