/**
 * The diagnosis: its verdict, the effects named, where the gap lies and how far it shrinks, as
 * values. Writes no files and draws nothing.
 */
@NullMarked
package simbad.gap.diagnosis;

import org.jspecify.annotations.NullMarked;
