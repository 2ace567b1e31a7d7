/**
 * What the machine has and lacks: which packages to install for what, what {@code doctor} says, how
 * the tests are run.
 *
 * <p>Needs nothing but the JDK: where the program is not built, {@code ./simbad} compiles these
 * classes on the spot.
 */
@NullMarked
package simbad.cli.machine;

import org.jspecify.annotations.NullMarked;
