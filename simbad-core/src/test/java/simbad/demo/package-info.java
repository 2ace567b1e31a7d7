/** Each demo does what its name says. */
@NullMarked
package simbad.demo;

import org.jspecify.annotations.NullMarked;
