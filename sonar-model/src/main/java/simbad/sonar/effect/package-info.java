/**
 * The effects that a simulator may not have modelled, each as a change of the nominal model, and
 * the diagnosed model that is made of them.
 *
 * <p>What a ping reads is put together in stages, and a change acts at one of them: where the
 * sensor and the obstacles really are, at which distance an obstacle is lost, what else answers,
 * what is lost, what range is measured, how it is reported. Knows no fitting, no files, no display.
 */
@NullMarked
package simbad.sonar.effect;

import org.jspecify.annotations.NullMarked;
