@NullMarked
package simbad.experiments.blindcheck;

import org.jspecify.annotations.NullMarked;
