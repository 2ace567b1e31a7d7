/** Tests of data sets made of other things. */
@NullMarked
package simbad.experiments.dataset;

import org.jspecify.annotations.NullMarked;
