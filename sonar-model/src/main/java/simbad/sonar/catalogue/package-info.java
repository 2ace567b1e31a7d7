/**
 * The catalogue of effects: one file for each, with all that is to be known of it. Nothing else in
 * the program speaks of an effect by name. It is found as a service, and knows what changes there
 * are and what a definition is, but not who asks.
 */
@NullMarked
package simbad.sonar.catalogue;

import org.jspecify.annotations.NullMarked;
