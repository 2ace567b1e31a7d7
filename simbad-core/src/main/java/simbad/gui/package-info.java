/**
 * Ways to run a simulation: in a window, or in batch without one.
 *
 * <p>The window is a view of the world. Steps go on on a thread of their own, commands to the
 * simulator go through another one, and the event thread waits for neither.
 *
 * <p>May not know: how a step is computed, how the world is drawn.
 */
@NullMarked
package simbad.gui;

import org.jspecify.annotations.NullMarked;
