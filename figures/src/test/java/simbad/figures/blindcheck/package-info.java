@NullMarked
package simbad.figures.blindcheck;

import org.jspecify.annotations.NullMarked;
