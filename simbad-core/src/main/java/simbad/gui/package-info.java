/**
 * Ways to run a simulation: without a window so far.
 *
 * <p>May not know: how a step is computed.
 */
@NullMarked
package simbad.gui;

import org.jspecify.annotations.NullMarked;
