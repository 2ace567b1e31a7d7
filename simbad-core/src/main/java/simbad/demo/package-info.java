/**
 * Environments that show what robots can do, and the list of all that there are: those here and
 * those that other jars provide as services of the type {@link simbad.demo.Demo}.
 *
 * <p>The names are Simbad's; what happens in the demos is this project's own. May not know: how
 * they are run.
 */
@NullMarked
package simbad.demo;

import org.jspecify.annotations.NullMarked;
