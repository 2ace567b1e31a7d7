/**
 * The motion effects of the vocabulary as changes of the chain from command to track, and the
 * catalogue of their forms. A form with neutral parameters changes no bit.
 */
@NullMarked
package simbad.motion.effect;

import org.jspecify.annotations.NullMarked;
