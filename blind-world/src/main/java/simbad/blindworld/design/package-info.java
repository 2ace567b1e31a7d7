/**
 * Scenes, set-ups and the ways in which they are measured, drawn at random. Knows nothing of
 * effects, so that no design can tell one.
 */
@NullMarked
package simbad.blindworld.design;

import org.jspecify.annotations.NullMarked;
