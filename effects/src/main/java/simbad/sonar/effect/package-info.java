/**
 * What a definition of an effect is: forms with their parameters, where a fit starts, a probe, a
 * remedy. Definitions are services; those of the project are in {@code simbad.sonar.catalogue}.
 */
@NullMarked
package simbad.sonar.effect;

import org.jspecify.annotations.NullMarked;
