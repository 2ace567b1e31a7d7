/**
 * Environments that show what robots can do; so far only their base class.
 *
 * <p>May not know: how they are run.
 */
@NullMarked
package simbad.demo;

import org.jspecify.annotations.NullMarked;
