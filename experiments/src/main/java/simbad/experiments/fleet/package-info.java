/**
 * Many robots at once, each in a world of its own, driven from outside: what a learning program
 * steps. Knows nothing of Python; the arrays are direct buffers that any other language can read.
 */
@NullMarked
package simbad.experiments.fleet;

import org.jspecify.annotations.NullMarked;
