/**
 * The changes of the nominal model that effects make, each at one stage of a ping. All are values:
 * their parameters are in SI units, and one value of each leaves the nominal model as it is.
 */
@NullMarked
package simbad.sonar.change;

import org.jspecify.annotations.NullMarked;
